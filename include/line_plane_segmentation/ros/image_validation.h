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

/// Why a frame is not processed.
enum class Refusal : std::uint8_t {
  kNone,          ///< it is processed
  kEmptyImage,    ///< width or height is 0
  kEncoding,      ///< not a depth image
  kTooLarge,      ///< more pixels than InputLimits::max_pixels, or more bytes than 32 bits can count
  kBadStep,       ///< rows shorter than their pixels
  kShortData,     ///< fewer bytes than the header says
  kInfoMismatch,  ///< camera_info is about an image of another size
  kNoIntrinsics,  ///< camera_info holds no usable focal lengths
  kTf,            ///< tf cannot tell where the camera is in the frame that planes are wanted in
  kUnorganized,   ///< a point cloud without rows and columns
  kCloudFields,   ///< a point cloud without x, y and z as floats
  kNotPinhole,    ///< a point cloud whose points a pinhole camera sees elsewhere
  kUndecodable,   ///< a compressed depth image whose pixels cannot be decoded
};

constexpr std::size_t kRefusalCount = 13;

/// The refusal's name as it stands in the diagnostics: "empty_image", "short_data" ...
const char* nameOf(Refusal refusal);

/// Bounds of InputLimits::depth_unit [m].
constexpr double kMinDepthUnit = 1e-6;
constexpr double kMaxDepthUnit = 0.1;

/// What the nodelet takes at most, and what its numbers mean.
struct InputLimits {
  std::uint64_t max_pixels = std::uint64_t{1} << 24;  ///< [px] of one image
  double depth_unit = 0.001;                          ///< [m] depth of one count of a 16-bit image
};

/// False for what no lens is like; points made with a usable camera do not overflow a float.
bool isUsable(const CameraIntrinsics& camera);

/// What validate() decided. `view` and `camera` are usable if `accepted()`.
struct Validation {
  Refusal refusal = Refusal::kNone;
  DepthView view;           ///< of the image's own bytes: valid as long as the image is (of a cloud: its z)
  CameraIntrinsics camera;  ///< of the view's pixels, binning and region of interest included
  bool intrinsics_from_k = false;  ///< P holds no focal lengths, K was taken
  bool distorted = false;          ///< camera_info or cloud has distortion: right if the image is rectified

  bool accepted() const { return refusal == Refusal::kNone; }
};

/// Decides about a depth image and its camera_info before any pixel is read. Looks at nothing but the
/// two headers and the number of bytes; allocates nothing and never throws, whatever they say.
Validation validate(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info,
                    const InputLimits& limits = {});

/// Returns whether camera_info describes images of this size, binning and region of interest included.
bool sizesMatch(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

/// Returns the intrinsics K of the image as the sensor gives it, binning and region of interest included.
CameraIntrinsics rawIntrinsics(const sensor_msgs::CameraInfo& info);

/// Returns those of P, of the rectified image.
CameraIntrinsics rectifiedIntrinsics(const sensor_msgs::CameraInfo& info);

/// One line for the user: what is wrong with these two, and what to do about it.
std::string explain(Refusal refusal, const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

}  // namespace line_plane_segmentation
