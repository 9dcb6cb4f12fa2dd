// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Limits of connected components above a plane that are objects.
struct ObjectParameters {
  /// [m²] Smallest plane on which objects are detected. Increase to use large tables only; decrease
  /// to use smaller surfaces.
  double min_support_area = 0.1;
  /// [m] Smallest height of an object's points above the plane. Increase to ignore flat objects;
  /// decrease to detect them.
  double min_object_height = 0.01;
  /// [m] Largest height of an object; higher components are ignored. Increase to detect taller
  /// objects, including furniture; decrease to ignore them.
  double max_object_height = 0.5;
  /// [m] Depth step between neighbouring pixels that separates two objects. Increase to keep
  /// objects whole; decrease to separate objects behind each other.
  double object_gap = 0.02;
  /// [px] Smallest object, 0 = from the image width. Increase to keep large objects only; decrease
  /// to find smaller objects.
  int min_object_pixels = 0;
};

/// Calls `visitor(name, value, min, max)` for each parameter, as visitParameters() does for the method's.
template <typename ParametersType, typename Visitor>
void visitObjectParameters(ParametersType& p, Visitor&& visitor) {
  visitor("min_support_area", p.min_support_area, 0.0, 100.0);
  visitor("min_object_height", p.min_object_height, 0.001, 1.0);
  visitor("max_object_height", p.max_object_height, 0.01, 3.0);
  visitor("object_gap", p.object_gap, 0.001, 1.0);
  visitor("min_object_pixels", p.min_object_pixels, 0, 1000000);
}

/// Visible part of an object on a plane, in the optical frame.
struct DetectedObject {
  std::size_t support = 0;                             ///< index of the plane in Segmentation::planes
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< [m] mean of its visible points
  RigidTransform box = RigidTransform::Identity();  ///< pose of the box's centre; z along the plane's normal
  Eigen::Vector3d size =
      Eigen::Vector3d::Zero();  ///< [m] size of the box, which reaches down to the plane; x >= y
  std::uint32_t pixels = 0;
  int first_column = 0, first_row = 0, columns = 0, rows = 0;  ///< [px] bounding rectangle in the image
};

/// Depth image and its planes. References only: the caller owns the data.
struct DepthScene {
  const DepthView& depth;
  const DepthRange& range;
  const CameraIntrinsics& camera;
  const Segmentation& segmentation;
};

/// Detects objects on supporting planes: connected components, in the image, of pixels whose points lie above
/// the convex hull of a plane's visible part. The plane nearest below a point supports it.
///
/// A connected component of a plane belongs to no object if most of its pixels lie elsewhere, as for a wall
/// behind a table. A component that rises above `max_object_height`, such as a person or a cupboard, is not
/// an object. Heights below three and gaps below four standard deviations of the depth noise are not
/// resolved. Not thread-safe.
class ObjectDetector {
 public:
  ObjectDetector();
  ~ObjectDetector();

  /// @param supports  indices into segmentation.planes; planes smaller than min_support_area are skipped
  /// @return the objects, largest first; valid until the next call
  const std::vector<DetectedObject>& detect(const DepthScene& scene, const std::vector<std::size_t>& supports,
                                            const ObjectParameters& parameters, const NoiseParameters& noise);

  /// Returns the supports of the last call that are large enough, as indices into segmentation.planes.
  const std::vector<std::size_t>& supports() const { return supports_; }

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
  std::vector<std::size_t> supports_;
  std::vector<DetectedObject> objects_;
};

}  // namespace line_plane_segmentation
