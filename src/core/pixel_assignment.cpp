// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/pixel_assignment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "row_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxSpeckle = 3;            // [px]
constexpr float kMaxSpeckleError = 2.0F;  // [-] in tolerances

}  // namespace

// A patch speaks for its own tile of the grid and for the eight around it.
void PixelAssigner::findSpans(const Tiles& tiles, int row, int width, std::vector<Span>& spans) {
  spans.clear();
  const int* const here = tiles.cluster_of + row * tiles.columns;
  const std::array<const int*, 3> rows = {row > 0 ? here - tiles.columns : here, here,
                                          row + 1 < tiles.rows ? here + tiles.columns : here};
  for (int c = 0; c < tiles.columns; ++c) {
    // Only -1, all of whose bits are set, is negative.
    if ((rows[0][c] & rows[1][c] & rows[2][c]) < 0) continue;
    const int first = std::max(0, c - 1) * tiles.spacing;
    const int last = c + 2 >= tiles.columns ? width : (c + 2) * tiles.spacing;
    for (const int* clusters : rows) {
      const int cluster = clusters[c];
      if (cluster < 0) continue;
      int& open = open_span_[static_cast<std::size_t>(cluster)];
      if (open >= 0 && spans[static_cast<std::size_t>(open)].last >= first) {
        spans[static_cast<std::size_t>(open)].last = last;
      } else {
        open = static_cast<int>(spans.size());
        spans.push_back({cluster, first, last});
      }
    }
  }
  for (const Span& span : spans) open_span_[static_cast<std::size_t>(span.cluster)] = -1;
}

void PixelAssigner::assignSpans(const std::vector<Span>& spans, const std::vector<PatchCluster>& clusters,
                                const float* z, const ViewRays& rays, double y, double plane_distance) {
  for (const Span& span : spans) {
    const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(span.cluster)].plane;
    const RowOfPlane row{static_cast<float>(plane.a), static_cast<float>(plane.b * y + plane.c),
                         static_cast<float>(1.0 / (plane_distance * plane.inverseDistance())),
                         static_cast<std::uint16_t>(span.cluster + 1)};
    assignIfBetter(z + span.first, depth_over_noise_.data() + span.first, rays.x.data() + span.first,
                   span.last - span.first, row, best_.data() + span.first, label_.data() + span.first);
  }
}

// Whether a few pixels of a row lie at the depth of those to their left and right.
bool PixelAssigner::isLikeNeighbors(const float* z, const LabelRun& before, const LabelRun& speckle,
                                    const LabelRun& after) const {
  const float expected = 0.5F * (1.0F / z[before.last - 1] + 1.0F / z[after.first]);
  for (int u = speckle.first; u < speckle.last; ++u) {
    const float error = std::fabs(1.0F - z[u] * expected) * depth_over_noise_[static_cast<std::size_t>(u)];
    if (error > kMaxSpeckleError) return false;
  }
  return true;
}

void PixelAssigner::assign(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
                           const std::vector<PatchCluster>& clusters, const std::vector<int>& cluster_of,
                           const Parameters& parameters, LabelRuns& image) {
  const std::size_t width = static_cast<std::size_t>(depth.width);
  for (std::vector<float>* row : {&depth_over_noise_, &best_}) row->resize(width);
  label_.resize(width);
  open_span_.assign(clusters.size(), -1);
  const float factor = static_cast<float>(parameters.extraction.distance_noise_factor);
  const RowNoise noise{static_cast<float>(parameters.noise.floor) * factor,
                       static_cast<float>(parameters.noise.growth) * factor,
                       static_cast<float>(parameters.noise.nearest)};

  fine_cluster_.assign(levels.fine.patch_at.size(), -1);
  for (int i = levels.firstFine(); i < levels.count(); ++i) {
    const int cell = levels.fine.cells[static_cast<std::size_t>(i - levels.firstFine())];
    fine_cluster_[static_cast<std::size_t>(cell)] = cluster_of[static_cast<std::size_t>(i)];
  }
  const Tiles coarse{levels.coarse.spacing, levels.coarse.columns, levels.coarse.rows, cluster_of.data()};
  const Tiles fine{levels.fine.spacing, levels.fine.columns, levels.fine.rows, fine_cluster_.data()};
  const double plane_distance = parameters.extraction.plane_distance;

  image.clear();
  spans_.clear();
  fine_spans_.clear();
  for (int v = 0, row = -1, fine_row = -1; v < depth.height; ++v) {
    const auto enter = [&](const Tiles& tiles, int& entered, std::vector<Span>& spans) {
      const int tile_row = std::min(v / tiles.spacing, tiles.rows - 1);
      if (tile_row != entered) findSpans(tiles, tile_row, depth.width, spans);
      entered = tile_row;
    };
    enter(coarse, row, spans_);
    if (!levels.fine.patches.empty()) enter(fine, fine_row, fine_spans_);
    const float* z = depth.row(v);
    const double y = rays.y[static_cast<std::size_t>(v)];
    prepareRow(z, depth.width, noise, depth_over_noise_.data(), best_.data(), label_.data());
    assignSpans(spans_, clusters, z, rays, y, plane_distance);
    assignSpans(fine_spans_, clusters, z, rays, y, plane_distance);
    image.addRow(label_.data(), depth.width);
    image.joinOverSpeckles(kMaxSpeckle,
                           [this, z](const LabelRun& before, const LabelRun& speckle, const LabelRun& after) {
                             return isLikeNeighbors(z, before, speckle, after);
                           });
  }
}

}  // namespace line_plane_segmentation
