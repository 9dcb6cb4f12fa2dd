// SPDX-License-Identifier: BSD-3-Clause
#include "core/region_cleanup_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "refine/label_runs.h"
#include "support/flood_fill.h"

namespace line_plane_segmentation {
namespace {

constexpr double kMaxMeanError = 2.0;

class Reference {
 public:
  Reference(const DepthImage& depth, const ViewRays& rays, const std::vector<PlaneCluster>& clusters,
            const Parameters& parameters, const std::vector<std::uint16_t>& labels)
      : depth_(depth), rays_(rays), clusters_(clusters), parameters_(parameters), labels_(labels) {}

  std::vector<std::uint16_t> clean() {
    findPieces();
    std::vector<std::uint16_t> cleaned = labels_;
    for (std::size_t i = 0; i < cleaned.size(); ++i) {
      if (labels_[i] == kNoDepthLabel) {
        cleaned[i] = 0;
      } else if (isSmall(i)) {
        cleaned[i] = targetLabelOf(component_of_[i]);
      }
    }
    return cleaned;
  }

 private:
  double inverseDepth(std::size_t pixel) const { return 1.0 / static_cast<double>(depth_.z[pixel]); }

  void findPieces() {
    component_of_.assign(labels_.size(), 0);
    std::size_t components = 0;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (component_of_[i] != 0) continue;
      const int width = depth_.width, at = static_cast<int>(i);
      const std::vector<std::uint8_t> region = floodFill(
          width, depth_.height, at % width, at / width,
          [&](int u, int v) { return labels_[depth_.index(u, v)] == labels_[i]; },
          [](int, int, int, int) { return true; });
      ++components;
      for (std::size_t k = 0; k < region.size(); ++k) component_of_[k] += region[k] * components;
    }
  }

  bool isSmall(std::size_t pixel) const {
    if (labels_[pixel] == kNoDepthLabel) return false;
    const auto pixels = std::count(component_of_.begin(), component_of_.end(), component_of_[pixel]);
    return pixels < parameters_.cleanup.min_region_pixels;
  }

  /// Whether a step in depth parts two neighbours: one that the noise of the farther one does not make.
  bool areParted(std::size_t a, std::size_t b) const {
    const DepthTolerance tolerance{parameters_.noise, parameters_.extraction.distance_noise_factor};
    const double w = inverseDepth(a), w_other = inverseDepth(b);
    return std::fabs(w - w_other) >= tolerance.along(std::min(w, w_other));
  }

  /// The labels beyond a component's border with large components, one for each pair of pixels: 0 behind a
  /// step.
  std::map<std::uint16_t, int> borderOf(std::size_t component) const {
    std::map<std::uint16_t, int> border;
    const auto meet = [&](std::size_t inside, std::size_t outside) {
      if (component_of_[inside] != component || component_of_[outside] == component) return;
      if (labels_[outside] == kNoDepthLabel || isSmall(outside)) return;
      ++border[areParted(inside, outside) ? std::uint16_t{0} : labels_[outside]];
    };
    const auto meet_both = [&](std::size_t a, std::size_t b) {
      meet(a, b);
      meet(b, a);
    };
    for (int v = 0; v < depth_.height; ++v) {
      for (int u = 0; u < depth_.width; ++u) {
        if (u > 0) meet_both(depth_.index(u - 1, v), depth_.index(u, v));
        if (v > 0) meet_both(depth_.index(u, v - 1), depth_.index(u, v));
      }
    }
    return border;
  }

  /// The label of more than half of a small component's border, if the component lies near that plane; else
  /// 0.
  std::uint16_t targetLabelOf(std::size_t component) {
    const auto known = target_labels_.find(component);
    if (known != target_labels_.end()) return known->second;
    const std::map<std::uint16_t, int> border = borderOf(component);
    int length = 0;
    for (const auto& [label, pixels] : border) length += pixels;
    std::uint16_t target_label = 0;
    for (const auto& [label, pixels] : border) {
      if (2 * pixels > length && label != 0 && meanError(component, label) <= kMaxMeanError)
        target_label = label;
    }
    return target_labels_[component] = target_label;
  }

  /// In tolerances.
  double meanError(std::size_t component, std::uint16_t label) const {
    const DepthTolerance tolerance{parameters_.noise, parameters_.extraction.distance_noise_factor,
                                   parameters_.extraction.plane_distance};
    const InverseDepthPlane& plane = clusters_[label - 1U].plane;
    double sum = 0.0;
    int pixels = 0;
    for (int v = 0; v < depth_.height; ++v) {
      for (int u = 0; u < depth_.width; ++u) {
        if (component_of_[depth_.index(u, v)] != component) continue;
        const double w = inverseDepth(depth_.index(u, v));
        const double expected =
            plane.at(rays_.x[static_cast<std::size_t>(u)], rays_.y[static_cast<std::size_t>(v)]);
        sum += std::fabs(w - expected) / tolerance.at(w, plane.inverseDistance());
        ++pixels;
      }
    }
    return sum / pixels;
  }

  const DepthImage& depth_;
  const ViewRays& rays_;
  const std::vector<PlaneCluster>& clusters_;
  const Parameters& parameters_;
  const std::vector<std::uint16_t>& labels_;
  std::vector<std::size_t> component_of_;  // of each pixel, from 1 on
  std::map<std::size_t, std::uint16_t> target_labels_;
};

}  // namespace

std::vector<std::uint16_t> referenceCleanup(const DepthImage& depth, const ViewRays& rays,
                                            const std::vector<PlaneCluster>& clusters,
                                            const Parameters& parameters,
                                            const std::vector<std::uint16_t>& labels) {
  return Reference(depth, rays, clusters, parameters, labels).clean();
}

}  // namespace line_plane_segmentation
