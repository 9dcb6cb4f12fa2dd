// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/eigen_types.h"

namespace line_plane_segmentation {

/// One closed ring of a plane's outline, a range of Segmentation::vertices.
struct Ring {
  int first_vertex = 0;
  int vertex_count = 0;  ///< at least 3; the first vertex is not repeated at the end
};

/// A plane of the picture: all p with normal . p + d = 0, in the optical frame. Not called Plane, since
/// the package's message has that name in this namespace, and programs include both.
struct SegmentedPlane {
  std::uint16_t label = 0;  ///< the value of its pixels in Segmentation::labels, from 1
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit, toward the camera
  double d = 0.0;                                      ///< [m] distance to the camera, not negative
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< [m] mean of its points
  /// Covariance of (nx, ny, nz, d) as the noise of the points makes it; singular along the normal,
  /// whose length is fixed.
  Covariance4d covariance = Covariance4d::Zero();
  std::uint32_t inliers = 0;  ///< pixels that carry the label
  double rms = 0.0;           ///< [m] root mean square distance of its points to the plane
  double area = 0.0;          ///< [m²] of the visible surface, holes left out

  /// Rings of the outline, ranges of Segmentation::rings: outer ones counterclockwise as seen from
  /// the camera, the largest first, then holes, clockwise. A point is inside if it is inside an odd
  /// number of rings.
  int first_ring = 0;
  int outer_ring_count = 0;
  int hole_count = 0;
};

/// What one depth image was cut into. Owned and reused by the segmenter.
struct Segmentation {
  int width = 0;                       ///< [px]
  int height = 0;                      ///< [px]
  std::vector<std::uint16_t> labels;   ///< width * height, row by row; 0 = no plane
  std::vector<SegmentedPlane> planes;  ///< planes[k - 1] has label k
  std::vector<Ring> rings;
  std::vector<Eigen::Vector3f> vertices;  ///< [m] on the planes, in the optical frame
  std::uint32_t valid_pixels = 0;         ///< pixels with a depth in range
  std::uint32_t assigned_pixels = 0;      ///< pixels with a label
};

}  // namespace line_plane_segmentation
