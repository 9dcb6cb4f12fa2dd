// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// Reason for refusing a frame.
enum class Refusal : std::uint8_t {
  kNone,          ///< not refused
  kEmptyImage,    ///< width or height is 0
  kEncoding,      ///< not a depth image
  kTooLarge,      ///< more pixels than InputLimits::max_pixels, or a size of 2^32 bytes or more
  kBadStep,       ///< rows shorter than their pixels
  kShortData,     ///< fewer bytes than the header states
  kInfoMismatch,  ///< camera_info belongs to an image of another size
  kNoIntrinsics,  ///< camera_info holds no usable focal lengths
  kTf,            ///< the camera's pose in the target frame is not available
  kUnorganized,   ///< a point cloud without rows and columns
  kCloudFields,   ///< a point cloud without x, y and z as floats
  kNotPinhole,    ///< a point cloud that no pinhole camera can have taken
  kUndecodable,   ///< a compressed depth image whose pixels cannot be decoded
};

constexpr std::size_t kRefusalCount = 13;

/// Returns the name used in the diagnostics: "empty_image", "short_data" ...
const char* nameOf(Refusal refusal);

/// Bounds of InputLimits::depth_unit [m].
constexpr double kMinDepthUnit = 1e-6;
constexpr double kMaxDepthUnit = 0.1;

/// Largest accepted image, and unit of 16-bit depths.
struct InputLimits {
  std::uint64_t max_pixels = std::uint64_t{1} << 24;  ///< [px] largest number of pixels of an image
  double depth_unit = 0.001;                          ///< [m] depth of one count of a 16-bit image
};

/// Returns false if the values are outside the range of real lenses. Points computed with a usable camera
/// do not overflow a float.
bool isUsable(const CameraIntrinsics& camera);

/// Result of validate(). `view` and `camera` are usable if `accepted()`.
struct Validation {
  Refusal refusal = Refusal::kNone;
  DepthView
      view;  ///< references the bytes of the image (of a cloud: the copied z) and is valid as long as these
  CameraIntrinsics camera;         ///< for the view's pixels, with binning and region of interest applied
  bool intrinsics_from_k = false;  ///< P has no focal lengths, K is used
  bool distorted =
      false;  ///< camera_info or cloud has distortion; the result is correct only if the image is rectified

  bool accepted() const { return refusal == Refusal::kNone; }
};

/// Validates a depth image and its camera_info before any pixel is read, from the two headers and the
/// number of bytes only. Never throws because of a message, and copies nothing whose length a message sets.
Validation validate(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info,
                    const InputLimits& limits = {});

/// Returns true if camera_info describes images of this size, with binning and region of interest applied.
bool sizesMatch(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

/// Returns the intrinsics K of the raw image, with binning and region of interest applied.
CameraIntrinsics rawIntrinsics(const sensor_msgs::CameraInfo& info);

/// Returns the intrinsics P of the rectified image, with binning and region of interest applied.
CameraIntrinsics rectifiedIntrinsics(const sensor_msgs::CameraInfo& info);

/// Returns one line for the user: the fault of the messages and its remedy.
std::string explain(Refusal refusal, const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

}  // namespace line_plane_segmentation
