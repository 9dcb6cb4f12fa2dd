// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace line_plane_segmentation {

/// Eigen types of the public interface that Eigen would otherwise align to the widest vector register that
/// the compiler's flags allow. Their size and alignment would then differ between a program built with
/// `-mavx2` and a library built without it. Eigen::Vector3d and Eigen::Vector3f are never aligned and are
/// used as they are. Conversions from and to Eigen's default types are implicit.
using Covariance2d = Eigen::Matrix<double, 2, 2, Eigen::DontAlign>;
using Covariance4d = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

/// Rotation and translation without alignment requirements, for the same reason as Covariance2d.
using RigidTransform = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// Direction of a scanline in the image.
enum class ScanDirection : unsigned char { kRow, kColumn };

/// Straight segment of one scanline: the line primitive of the paper.
struct LineSegment {
  ScanDirection direction = ScanDirection::kRow;
  int scanline = 0;  ///< [px] row (or column) of the image
  int first = 0;     ///< [px] column (or row) of its first point
  int last = 0;      ///< [px] column (or row) of its last point, inclusive
  int points = 0;    ///< number of valid pixels from first to last

  /// Polar form in the 2-D scan (Eq. 1-3): Sx cos(alpha) + Sy sin(alpha) = r.
  double alpha = 0.0;                              ///< [rad]
  double r = 0.0;                                  ///< [m], not negative
  Covariance2d covariance = Covariance2d::Zero();  ///< covariance of (alpha, r) from the noise model, Eq. 5
};

/// Local plane at a pixel of a line segment, from which a plane can be extracted.
struct PlaneCandidate {
  int u = 0;                                         ///< [px] column of the pixel
  int v = 0;                                         ///< [px] row of the pixel
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit normal, towards the camera
  double d = 0.0;                                    ///< [m] normal . p + d = 0
  double curvature = 0.0;  ///< ratio of the smallest eigenvalue to the sum of all three, 0 (flat) to 1/3
};

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

/// Assigns each hole of a plane to the connected part of the plane that contains it: the smallest outer ring
/// that encloses most of the hole's vertices. If simplification has moved all of a hole's vertices out of the
/// outer rings, the hole belongs to the largest part.
/// @param plane  one of segmentation.planes
/// @return index of the part's outer ring per hole, in the order of the rings; 0 is the largest part
std::vector<int> partsOfHoles(const Segmentation& segmentation, const SegmentedPlane& plane);

/// Transforms coefficients, their covariance and the centroid of a plane from the optical frame to another
/// one. The normal still points towards the camera, which need not be at the origin, so d can be negative.
/// @param target_from_optical  maps points of the optical frame to the target frame
SegmentedPlane transformed(const SegmentedPlane& plane, const RigidTransform& target_from_optical);

}  // namespace line_plane_segmentation
