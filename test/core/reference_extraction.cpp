// SPDX-License-Identifier: BSD-3-Clause
#include "reference_extraction.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "kernels/row_kernels.h"
#include "support/flood_fill.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

float at(const std::vector<float>& rays, int pixel) { return rays[static_cast<std::size_t>(pixel)]; }

int validPointsAround(const PlaneCandidate& candidate, int side, const DepthImage& remaining) {
  int count = 0;
  for (int v = candidate.v - side / 2; v < candidate.v - side / 2 + side; ++v) {
    for (int u = candidate.u - side / 2; u < candidate.u - side / 2 + side; ++u) {
      if (u < 0 || u >= remaining.width || v < 0 || v >= remaining.height) continue;
      count += remaining.at(u, v) > 0.0F ? 1 : 0;
    }
  }
  return count;
}

// The two distances are those of row_kernels.h, tested there: in single precision, so that both sides round
// alike.
std::vector<std::uint8_t> inliersOf(const PlaneCandidate& candidate, const DepthImage& remaining,
                                    const ViewRays& rays, const ExtractionParameters& parameters) {
  const Eigen::Vector3f normal = candidate.normal.cast<float>();
  const float d = static_cast<float>(candidate.d);
  const float plane_distance = static_cast<float>(parameters.plane_distance);
  const float neighbor_distance = static_cast<float>(parameters.neighbor_distance);
  const auto is_inlier = [&](int u, int v) {
    const float z = remaining.at(u, v);
    const float a = normal.y() * at(rays.y, v) + normal.z();
    return z > 0.0F && std::fabs(planeDistance(z, at(rays.x, u), a, normal.x(), d)) < plane_distance;
  };
  const auto is_near = [&](int u0, int v0, int u1, int v1) {
    return squaredDistance(remaining.at(u0, v0), at(rays.x, u0), at(rays.y, v0), remaining.at(u1, v1),
                           at(rays.x, u1), at(rays.y, v1)) < neighbor_distance * neighbor_distance;
  };
  return floodFill(remaining.width, remaining.height, candidate.u, candidate.v, is_inlier, is_near);
}

std::ptrdiff_t sizeOf(const std::vector<std::uint8_t>& region) {
  return std::count(region.begin(), region.end(), 1);
}

std::optional<PlaneFit> refit(const std::vector<std::uint8_t>& inliers, const DepthImage& depth,
                              const ViewRays& rays) {
  PointMoments moments;
  for (int v = 0; v < depth.height; ++v) {
    for (int u = 0; u < depth.width; ++u) {
      if (inliers[depth.index(u, v)] != 0) moments.add(pointAt(depth, rays, u, v));
    }
  }
  PlaneFit plane;
  constexpr double kEdgeOn = 1e-6;
  if (!fitPlane(moments, plane) || plane.d < kEdgeOn * plane.centroid.norm()) return std::nullopt;
  return plane;
}

}  // namespace

ReferenceResult referenceExtraction(const DepthImage& depth, const ViewRays& rays,
                                    std::vector<PlaneCandidate> candidates, const Parameters& parameters) {
  ReferenceResult result;
  result.labels.assign(depth.z.size(), 0);
  DepthImage remaining = depth;
  while (!candidates.empty()) {
    std::vector<PlaneCandidate> left;
    std::vector<std::uint8_t> most;
    for (const PlaneCandidate& candidate : candidates) {
      if (validPointsAround(candidate, parameters.candidates.normal_window, remaining) <
          parameters.candidates.min_window_points) {
        continue;
      }
      std::vector<std::uint8_t> inliers = inliersOf(candidate, remaining, rays, parameters.extraction);
      if (sizeOf(inliers) < parameters.extraction.min_plane_inliers) continue;
      left.push_back(candidate);
      if (sizeOf(inliers) > sizeOf(most)) most = std::move(inliers);
    }
    candidates = std::move(left);
    if (candidates.empty()) break;

    result.planes.push_back(refit(most, depth, rays));
    for (std::size_t i = 0; i < most.size(); ++i) {
      if (most[i] == 0) continue;
      result.labels[i] = static_cast<std::uint16_t>(result.planes.size());
      remaining.z[i] = 0.0F;
    }
  }
  return result;
}

}  // namespace line_plane_segmentation
