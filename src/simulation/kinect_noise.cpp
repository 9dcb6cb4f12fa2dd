// SPDX-License-Identifier: BSD-3-Clause
#include "kinect_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "random.h"

namespace line_plane_segmentation::simulation {
namespace {

/// Purposes of a pixel's random numbers; each has its own counter.
enum Draw : std::uint64_t { kTosses, kFill, kDropout, kDrawsPerPixel };

/// The random numbers of one frame.
class FrameRandom {
 public:
  FrameRandom(std::uint64_t seed, std::uint64_t frame) : key_(randomBits(mixBits(seed), frame)) {}

  std::uint64_t bits(std::size_t pixel, Draw draw) const {
    return randomBits(key_, pixel * kDrawsPerPixel + draw);
  }
  double normal(std::size_t pixel) const { return toNormal(bits(pixel, kTosses), bits(pixel, kFill)); }
  double uniform(std::size_t pixel) const { return toUniform(bits(pixel, kDropout)); }

 private:
  std::uint64_t key_;
};

/// Writes the depth of what the projector lights, 0 for the rest of the row. From the projector's side, a
/// point is in shadow if the projector sees it no farther left than something to its right.
/// @param shift  [px m] how much farther left the projector sees a point than the camera, times its depth
void removeShadow(const float* depth, std::size_t width, double shift, float* lit) {
  double leftmost = std::numeric_limits<double>::infinity();
  for (std::size_t u = width; u-- > 0;) {
    lit[u] = 0.0F;
    if (!(depth[u] > 0.0F)) continue;
    const double seen_by_projector = static_cast<double>(u) - shift / static_cast<double>(depth[u]);
    if (seen_by_projector < leftmost) {
      leftmost = seen_by_projector;
      lit[u] = depth[u];
    }
  }
}

/// Finds the pixels of row `v` that differ from one of their four neighbours by a depth edge, or touch
/// what has no depth.
void markEdges(const Rendering& picture, int v, float jump, std::vector<std::uint8_t>& edges) {
  const auto width = static_cast<std::size_t>(picture.width);
  const float* row = picture.depth.data() + static_cast<std::size_t>(v) * width;
  const float* above = v > 0 ? row - width : row;
  const float* below = v + 1 < picture.height ? row + width : row;
  // |1/z - 1/z'| > jump, without a division, and true if one of the two is 0.
  const auto differs = [jump](float z, float other) { return std::abs(z - other) > jump * z * other; };
  for (std::size_t u = 0; u < width; ++u) {
    edges[u] = static_cast<std::uint8_t>(differs(row[u], above[u]) || differs(row[u], below[u]));
  }
  for (std::size_t u = 1; u < width; ++u) {
    const bool jumps = differs(row[u], row[u - 1]);
    edges[u] = static_cast<std::uint8_t>(edges[u] | jumps);
    edges[u - 1] = static_cast<std::uint8_t>(edges[u - 1] | jumps);
  }
}

/// How many pixels go missing because light hardly comes back from so grazed a surface.
class GrazingModel {
 public:
  GrazingModel(const KinectNoiseParameters& p, const Rendering& picture)
      : start_(std::cos(p.grazing_start)), end_(std::cos(p.grazing_end)) {
    // Label 0, curved or nothing, is never grazed: the steep parts of a curved surface are edges already.
    distances_.assign(picture.planes.empty() ? 1U : picture.planes.back().label + 1U, kAlwaysSeen);
    for (const VisiblePlane& plane : picture.planes) distances_[plane.label] = plane.d;
  }

  /// @param reach  [m] of the pixel's point from the camera, along its ray, squared
  /// @return the missing fraction, 0 to 1
  double missingShare(std::uint16_t label, double squared_reach) const {
    const double d = distances_[label];
    if (d * d >= start_ * start_ * squared_reach) return 0.0;
    const double cosine = d / std::sqrt(squared_reach);  // of the angle between ray and normal
    return std::clamp((start_ - cosine) / (start_ - end_), 0.0, 1.0);
  }

 private:
  static constexpr double kAlwaysSeen = 1e9;  // [m]

  double start_;
  double end_;
  std::vector<double> distances_;  // [m] of each label's plane to the camera
};

/// All that happens along the ray: noise and the depth's levels.
class AxialModel {
 public:
  explicit AxialModel(const KinectNoiseParameters& p)
      : noise_(p.axial),
        level_(p.disparity_step > 0.0 ? p.focal_length * p.baseline / p.disparity_step : 0.0),
        min_range_(p.min_range),
        max_range_(p.max_range) {}

  /// Measures the pixels of a row. Written without a branch for each pixel, so that it vectorises.
  /// @param z        [m] true depth, 0 = missing
  /// @param normals  of N(0, 1)
  /// @param mm       [mm] 0 = missing or out of range
  void measure(const std::vector<float>& z, const std::vector<double>& normals, std::uint16_t* mm) const {
    const double per_level = level_ > 0.0 ? 1.0 / level_ : 0.0;
    for (std::size_t u = 0; u < z.size(); ++u) {
      const double depth = static_cast<double>(z[u]);
      const double sigma = noise_.sigma(depth);
      const double step = depth * depth * per_level;
      const double rest = std::sqrt(std::max(sigma * sigma - step * step * (1.0 / 12.0), 0.0));
      const double noisy = std::max(depth + rest * normals[u], 0.5 * min_range_);
      const double measured = level_ > 0.0 ? level_ / roundPositive(level_ / noisy) : noisy;
      const bool in_range = depth > 0.0 && measured >= min_range_ && measured <= max_range_;
      mm[u] = static_cast<std::uint16_t>(static_cast<int>((in_range ? measured : 0.0) * 1000.0 + 0.5));
    }
  }

 private:
  static double roundPositive(double x) { return static_cast<int>(std::min(x + 0.5, 1e9)); }

  NoiseParameters noise_;
  double level_;  // [m] depth of disparity level 1: level k is at level_ / k
  double min_range_;
  double max_range_;
};

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(what);
}

}  // namespace

KinectNoise::KinectNoise(const KinectNoiseParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed) {
  const KinectNoiseParameters& p = parameters_;
  require(p.axial.floor >= 0.0 && p.axial.growth >= 0.0 && std::isfinite(p.axial.nearest), "axial noise");
  require(p.focal_length > 0.0 && p.baseline > 0.0 && p.disparity_step >= 0.0, "disparity");
  require(p.min_range > 0.0 && p.min_range < p.max_range && p.max_range <= 65.535, "range");
  require(p.edge_jump > 0.0 && p.edge_dropout >= 0.0 && p.edge_dropout <= 1.0, "depth edges");
  require(p.grazing_start < p.grazing_end, "grazing angles");
}

void KinectNoise::apply(const Rendering& rendering, const CameraIntrinsics& k, std::uint64_t frame,
                        std::uint16_t* depth_mm) const {
  const auto width = static_cast<std::size_t>(rendering.width);
  const FrameRandom random(seed_, frame);
  const AxialModel axial(parameters_);
  const GrazingModel grazing(parameters_, rendering);
  const double shift = parameters_.projector_shadow ? k.fx * parameters_.baseline : 0.0;
  std::vector<float> lit(width);
  std::vector<double> normals(width);
  std::vector<std::uint8_t> edges(width);
  for (int v = 0; v < rendering.height; ++v) {
    const std::size_t start = static_cast<std::size_t>(v) * width;
    std::uint16_t* row_mm = depth_mm + start;
    removeShadow(rendering.depth.data() + start, width, shift, lit.data());
    for (std::size_t u = 0; u < width; ++u) normals[u] = random.normal(start + u);
    axial.measure(lit, normals, row_mm);

    markEdges(rendering, v, static_cast<float>(parameters_.edge_jump), edges);
    const double y = (v - k.cy) / k.fy;
    for (std::size_t u = 0; u < width; ++u) {
      const double z = static_cast<double>(lit[u]);
      const double x = (static_cast<double>(u) - k.cx) / k.fx;
      const double grazed = grazing.missingShare(rendering.labels[start + u], z * z * (x * x + y * y + 1.0));
      const double missing = std::max(grazed, edges[u] != 0 ? parameters_.edge_dropout : 0.0);
      if (missing > 0.0 && random.uniform(start + u) < missing) row_mm[u] = 0;
    }
  }
}

}  // namespace line_plane_segmentation::simulation
