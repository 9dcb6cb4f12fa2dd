// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "line_plane_segmentation/eigen_types.h"

namespace line_plane_segmentation {

/// Closed ring of a plane's outline: a range of Segmentation::vertices.
struct Ring {
  int first_vertex = 0;
  int vertex_count = 0;  ///< at least 3; the first vertex is not repeated at the end
};

/// Plane of an image: all points p with normal . p + d = 0, in the optical frame. Its name differs from that
/// of the message Plane, which is in the same namespace.
struct SegmentedPlane {
  std::uint16_t label = 0;                           ///< value of its pixels in Segmentation::labels, from 1
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit normal, towards the camera
  double d = 0.0;                                    ///< [m] distance to the camera, at least 0
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< [m] mean of the inliers' points
  /// Covariance of (nx, ny, nz, d) from the noise of the points. Singular along the normal, whose length is
  /// fixed.
  Covariance4d covariance = Covariance4d::Zero();
  std::uint32_t inliers = 0;  ///< number of pixels with the label
  double rms = 0.0;           ///< [m] root mean square orthogonal distance of the inliers to the plane
  double area = 0.0;  ///< [m²] area of the visible surface, without holes but with pixels whose depth
                      ///< is missing between those of the plane, as outlines go round them

  /// Rings of the outline, a range of Segmentation::rings: first the outer rings, counterclockwise as seen
  /// from the camera, the largest first; then the holes, clockwise. A point is inside the outline if an odd
  /// number of rings encloses it.
  int first_ring = 0;
  int outer_ring_count = 0;
  int hole_count = 0;
};

/// Segmentation of one depth image. Owned by the segmenter, which overwrites it with the next image.
struct Segmentation {
  int width = 0;                       ///< [px]
  int height = 0;                      ///< [px]
  std::vector<std::uint16_t> labels;   ///< label per pixel, width * height, row by row; 0 = no plane
  std::vector<SegmentedPlane> planes;  ///< planes[k - 1] has label k
  std::vector<Ring> rings;
  std::vector<Eigen::Vector3f> vertices;  ///< [m] points on the planes, in the optical frame
  std::uint32_t valid_pixels = 0;         ///< number of pixels with a depth in range
  std::uint32_t assigned_pixels = 0;      ///< number of pixels with a label
};

}  // namespace line_plane_segmentation
