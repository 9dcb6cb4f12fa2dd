// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/crease.h"
#include "line_plane_segmentation/label_runs.h"
#include "line_plane_segmentation/patch_clustering.h"

namespace line_plane_segmentation {

/// Stage 4 of the adaptive method, second half: which pixels are in which plane. A pixel goes to the plane
/// that it fits best of those with a patch nearby, if it lies within the tolerance; so at the meeting of two
/// planes the line where both fit alike parts them, and no plane reaches into a surface far from its patches.
/// Where planes that are known to meet differ by less than the noise, a pixel goes to the plane on its side
/// of that line.
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
    const int* cluster_at;
  };

  void findSpans(const Tiles& tiles, int row, int width, std::vector<Span>& spans);
  void assignSpans(const std::vector<Span>& spans, const std::vector<PatchCluster>& clusters, const float* z,
                   const ViewRays& rays, double y);

  /// The line where two planes meet, in columns first to last - 1: in the row with the ray y it is at the
  /// column offset + y * per_y, and up to `reach` columns from there the planes are alike.
  struct Meeting {
    int first, last;
    double offset, per_y, reach;
    std::uint16_t left, right;  ///< labels of the planes on either side
  };

  void findMeetings(const std::vector<PatchCluster>& clusters, const ViewRays& rays, double y,
                    const DepthTolerance& tolerance);
  void partAtCreases(double y);

  bool isLikeNeighbors(const float* z, const LabelRun& before, const LabelRun& speckle,
                       const LabelRun& after) const;

  std::vector<Span> spans_, fine_spans_;  // of the rows of tiles that the image's row lies in
  std::vector<Meeting> meetings_;
  Creases creases_;
  std::vector<float> inverse_across_;               // of each cluster, as in RowOfPlane
  std::vector<int> coarse_cluster_, fine_cluster_;  // of each crossing, or -1
  std::vector<int> open_span_;  // of each cluster, in the row of the grid being looked at; -1 if none
  // One row of the image.
  std::vector<float> depth_over_noise_, best_;
  std::vector<std::uint16_t> label_;
};

}  // namespace line_plane_segmentation
