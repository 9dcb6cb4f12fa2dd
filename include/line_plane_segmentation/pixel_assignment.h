// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/label_runs.h"
#include "line_plane_segmentation/patch_clustering.h"

namespace line_plane_segmentation {

/// Stage 4 of the adaptive method, second half: which pixels are in which plane. A pixel goes to the plane
/// that it fits best of those with a patch nearby, if it lies within the tolerance; so at the meeting of two
/// planes the line where both fit alike parts them, and no plane reaches into a surface far from its patches.
class PixelAssigner {
 public:
  /// @param image  k + 1 for cluster k, 0 for no plane, kNoDepthLabel for no depth
  void assign(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
              const std::vector<PatchCluster>& clusters, const std::vector<int>& cluster_of,
              const Parameters& parameters, LabelRuns& image);

 private:
  /// Columns first to last - 1 of the image, in which a plane is asked.
  struct Span {
    int cluster, first, last;
  };

  /// The clusters of a grid of square tiles; -1 is none.
  struct Tiles {
    int spacing, columns, rows;
    const int* cluster_of;
  };

  void findSpans(const Tiles& tiles, int row, int width, std::vector<Span>& spans);
  void assignSpans(const std::vector<Span>& spans, const std::vector<PatchCluster>& clusters, const float* z,
                   const ViewRays& rays, double y, double plane_distance);

  bool isLikeNeighbors(const float* z, const LabelRun& before, const LabelRun& speckle,
                       const LabelRun& after) const;

  std::vector<Span> spans_, fine_spans_;  // of the rows of tiles that the image's row lies in
  std::vector<int> fine_cluster_;         // of each fine crossing, or -1
  std::vector<int> open_span_;  // of each cluster, in the row of the grid being looked at; -1 if none
  // One row of the image.
  std::vector<float> depth_over_noise_, best_;
  std::vector<std::uint16_t> label_;
};

}  // namespace line_plane_segmentation
