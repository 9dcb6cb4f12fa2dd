// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planes/plane_clustering.h"
#include "refine/crease.h"
#include "refine/label_runs.h"

namespace line_plane_segmentation {

/// Stage "extraction" of the default method, second half: which pixels are in which plane.
///
/// Each pixel is assigned to the plane that it fits best, among those with a candidate in the same or an
/// adjacent tile of the scanline grid, if it lies within the tolerance, so that no plane extends into a
/// surface far from its candidates. Where two planes that meet in a crease differ by less than the
/// noise's tolerance (distance_noise_factor), a pixel is assigned by the side of their line of intersection
/// that it lies on.
class PixelAssigner {
 public:
  /// @param cluster_at  index in `clusters` per crossing of the grid, -1 if none
  /// @param image  receives k + 1 for cluster k, 0 for no plane, kNoDepthLabel for invalid depth
  void assign(const DepthImage& depth, const ViewRays& rays, const CandidateGrid& grid,
              const std::vector<PlaneCluster>& clusters, const std::vector<int>& cluster_at,
              const Parameters& parameters, LabelRuns& image);

 private:
  /// Columns first to last - 1 of the image, in which a plane is compared.
  struct Span {
    int cluster, first, last;
  };

  void findSpans(const CandidateGrid& grid, const std::vector<int>& cluster_at, int row, int width);
  void assignSpans(const std::vector<PlaneCluster>& clusters, const float* z, const ViewRays& rays, double y);

  /// The line of intersection of two planes, in columns first to last - 1: in the row with the ray y it is at
  /// the column offset + y * per_y, and up to `reach` columns from it the planes differ by less than
  /// the noise's tolerance.
  struct PlaneIntersection {
    int first, last;
    double offset, per_y, reach;
    std::uint16_t left, right;  ///< labels of the planes on either side
  };

  void intersectPlanes(const std::vector<PlaneCluster>& clusters, const ViewRays& rays, double y,
                       const DepthTolerance& tolerance);
  void splitAtCreases(double y);
  bool isLikeNeighbors(const float* z, const LabelRun& before, const LabelRun& speckle,
                       const LabelRun& after) const;

  std::vector<Span> spans_;  // of the row of tiles that the image row lies in
  std::vector<PlaneIntersection> intersections_;
  Creases creases_;
  std::vector<int> open_span_;                   // index of a span per cluster, -1 if none
  std::vector<float> inv_orthogonal_tolerance_;  // [-] per cluster, as in RowOfPlane
  // One row of the image.
  std::vector<float> depth_over_noise_, best_;
  std::vector<std::uint16_t> label_;
};

}  // namespace line_plane_segmentation
