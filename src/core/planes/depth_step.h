// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/parameters.h"
#include "planes/crossing_candidates.h"

namespace line_plane_segmentation {

/// Difference in depth along the ray beyond which two surfaces are not one plane: the noise, and the distance
/// that a pixel may have from its plane.
DepthTolerance stepTolerance(const Parameters& parameters);

/// Difference in inverse depth of two planes at the ray (x, y, 1) [tolerances], positive if `other` is
/// nearer.
double differenceAt(double x, double y, const InverseDepthPlane& plane, const InverseDepthPlane& other,
                    const DepthTolerance& tolerance);

/// Where two clusters of candidates meet on a scanline.
struct ClusterContact {
  /// The candidates on both sides of the border.
  const CrossingCandidate *from, *to;
  /// The next candidates away from the border if they are in the same clusters, otherwise `from` and `to`:
  /// the windows of those may lie across the border.
  const CrossingCandidate *behind_from, *behind_to;
};

/// Largest distance between the two candidates at a contact [crossings]. At the crossing between them, no
/// candidate or one of a third cluster may be, if its windows lie across the border.
constexpr int kMaxContactDistance = 2;

/// The contact of the clusters at two crossings of a scanline.
/// @param to_right, below  one step from the first crossing towards the other one
/// @param cluster_at       returns the cluster at a crossing, -1 if there is none
template <typename Function>
ClusterContact contactBetween(const CandidateGrid& grid, int from, int to, int to_right, int below,
                              Function&& cluster_at) {
  const auto behind = [&](int cell, int right, int down) {
    const int next = grid.cellBeside(cell, right, down);
    return &grid.candidateAt(next >= 0 && cluster_at(next) == cluster_at(cell) ? next : cell);
  };
  return {&grid.candidateAt(from), &grid.candidateAt(to), behind(from, -to_right, -below),
          behind(to, to_right, below)};
}

/// The step from one plane to another at a contact of their clusters [tolerances], positive if the other one
/// is nearer. `plane` is that of the cluster of `from`, `other` that of `to`. The planes are compared halfway
/// between both candidates, each moved by the deviation of its cluster there: distortion bends a surface away
/// from its plane, but makes no step.
double stepAt(const ClusterContact& contact, const InverseDepthPlane& plane, const InverseDepthPlane& other,
              const DepthTolerance& tolerance);

/// Mean of the steps along the border of two clusters.
class MeanStep {
 public:
  void add(double step) {
    ++count_;
    sum_ += step;
    squares_ += step * step;
  }
  MeanStep& operator+=(const MeanStep& other);

  /// Whether the clusters are at different depths: by more than a tolerance, and three standard errors.
  bool isStep() const;

 private:
  int count_ = 0;
  double sum_ = 0.0, squares_ = 0.0;
};

}  // namespace line_plane_segmentation
