// SPDX-License-Identifier: BSD-3-Clause
#include "planes/depth_step.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr int kMinContacts = 5;
constexpr double kStandardErrors = 3.0;

// A plane moved to the depth of a candidate of its cluster.
InverseDepthPlane moved(InverseDepthPlane plane, const CrossingCandidate& candidate) {
  plane.c += candidate.deviationFrom(plane);
  return plane;
}

}  // namespace

DepthTolerance stepTolerance(const Parameters& parameters) {
  return {parameters.noise, parameters.patches.patch_noise_factor,
          std::max(parameters.extraction.plane_distance, parameters.patches.patch_distance)};
}

double differenceAt(double x, double y, const InverseDepthPlane& plane, const InverseDepthPlane& other,
                    const DepthTolerance& tolerance) {
  const double rho = plane.at(x, y), other_rho = other.at(x, y);
  const double inverse_distance = 0.5 * (plane.inverseDistance() + other.inverseDistance());
  return (other_rho - rho) / tolerance.at(0.5 * (rho + other_rho), inverse_distance);
}

double stepAt(const ClusterContact& contact, const InverseDepthPlane& plane, const InverseDepthPlane& other,
              const DepthTolerance& tolerance) {
  const double x = 0.5 * (contact.from->x + contact.to->x), y = 0.5 * (contact.from->y + contact.to->y);
  return differenceAt(x, y, moved(plane, *contact.behind_from), moved(other, *contact.behind_to), tolerance);
}

MeanStep& MeanStep::operator+=(const MeanStep& other) {
  count_ += other.count_;
  sum_ += other.sum_;
  squares_ += other.squares_;
  return *this;
}

bool MeanStep::isStep() const {
  if (count_ < kMinContacts) return false;
  const double mean = sum_ / count_;
  const double squared_error = std::max(0.0, squares_ / count_ - mean * mean) / (count_ - 1);
  return std::fabs(mean) > std::max(1.0, kStandardErrors * std::sqrt(squared_error));
}

}  // namespace line_plane_segmentation
