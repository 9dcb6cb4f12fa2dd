// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/eigen_types.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Which components above a plane count as objects that stand on it.
struct ObjectParameters {
  double min_support_area = 0.1;    ///< [m²] smallest plane on which objects are looked for
  double min_object_height = 0.01;  ///< [m] points nearer to the plane belong to its surface
  double max_object_height = 0.5;   ///< [m] a component that rises higher is not an object
  double object_gap = 0.02;         ///< [m] depth step between neighbouring pixels that separates two objects
  int min_object_pixels = 0;        ///< [px] smallest object, 0 = from the image's width: 200 at 640
};

/// As visitParameters() for the method's parameters: the one list of names and bounds.
template <typename ParametersType, typename Visitor>
void visitObjectParameters(ParametersType& p, Visitor&& visitor) {
  visitor("min_support_area", p.min_support_area, 0.0, 100.0);
  visitor("min_object_height", p.min_object_height, 0.001, 1.0);
  visitor("max_object_height", p.max_object_height, 0.01, 3.0);
  visitor("object_gap", p.object_gap, 0.001, 1.0);
  visitor("min_object_pixels", p.min_object_pixels, 0, 1000000);
}

/// An object that stands on a plane, as far as the camera sees it. All in the optical frame.
struct DetectedObject {
  std::size_t support = 0;                             ///< index of the plane in Segmentation::planes
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< [m] mean of its visible points
  RigidTransform box = RigidTransform::Identity();     ///< the box's centre; z along the plane's normal
  Eigen::Vector3d size =
      Eigen::Vector3d::Zero();  ///< [m] of the box, which reaches down to the plane; x >= y
  std::uint32_t pixels = 0;
  int first_column = 0, first_row = 0, columns = 0, rows = 0;  ///< [px] bounding rectangle in the image
};

/// A depth image and its planes, none of which this owns.
struct DepthScene {
  const DepthView& depth;
  const DepthRange& range;
  const CameraIntrinsics& camera;
  const Segmentation& segmentation;
};

/// Detects objects on supporting planes: connected components, in the image, of pixels whose points lie above
/// the convex hull of a plane's visible part. The plane nearest below a point supports it.
///
/// Connected components of a plane of which most pixels lie elsewhere, such as a wall behind a table, belong
/// to no object. A component that rises above `max_object_height` is not an object: a person, a cupboard.
/// Heights and gaps below three and four standard deviations of the depth noise are not resolved. Not
/// thread-safe.
class ObjectDetector {
 public:
  ObjectDetector();
  ~ObjectDetector();

  /// @param supports  indices in segmentation.planes; those of less than min_support_area are skipped
  /// @return the objects, largest first; valid until the next call
  const std::vector<DetectedObject>& detect(const DepthScene& scene, const std::vector<std::size_t>& supports,
                                            const ObjectParameters& parameters, const NoiseParameters& noise);

  /// The supports of the last call that were large enough, as indices in segmentation.planes.
  const std::vector<std::size_t>& supports() const { return supports_; }

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
  std::vector<std::size_t> supports_;
  std::vector<DetectedObject> objects_;
};

}  // namespace line_plane_segmentation
