// SPDX-License-Identifier: BSD-3-Clause
#include "image_validation.h"

#include <image_geometry/pinhole_camera_model.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "printable_text.h"

namespace line_plane_segmentation {
namespace {

// Range of real lenses. Points computed with values in this range do not overflow a float.
constexpr double kMinFocalLength = 1e-2;  // [px]
constexpr double kMaxPixelNumber = 1e7;   // [px]

bool depthTypeOf(const std::string& encoding, DepthType& type) {
  namespace enc = sensor_msgs::image_encodings;
  if (encoding == enc::TYPE_16UC1 || encoding == enc::MONO16) {
    type = DepthType::kUint16;
  } else if (encoding == enc::TYPE_32FC1) {
    type = DepthType::kFloat32;
  } else {
    return false;
  }
  return true;
}

// Sizes are multiplied in 64 bits, where the 32-bit values of the header cannot overflow.
Refusal makeView(const sensor_msgs::Image& image, const InputLimits& limits, DepthView& view) {
  if (image.width == 0 || image.height == 0) return Refusal::kEmptyImage;
  DepthType type = DepthType::kUint16;
  if (!depthTypeOf(image.encoding, type)) return Refusal::kEncoding;

  const std::uint64_t width = image.width;
  const std::uint64_t height = image.height;
  const std::uint64_t step = image.step;
  const std::uint64_t max_pixels =
      std::min<std::uint64_t>(limits.max_pixels, std::numeric_limits<int>::max());
  if (width * height > max_pixels || height * step > std::numeric_limits<std::uint32_t>::max()) {
    return Refusal::kTooLarge;
  }
  if (step < width * bytesPerPixel(type)) return Refusal::kBadStep;
  if (image.data.size() < height * step) return Refusal::kShortData;

  view.data = image.data.data();
  view.width = static_cast<int>(width);
  view.height = static_cast<int>(height);
  view.step = static_cast<std::size_t>(step);
  view.type = type;
  view.depth_unit = type == DepthType::kUint16 ? static_cast<float>(limits.depth_unit) : 1.0F;
  view.swap_bytes = (image.is_bigendian != 0) != (boost::endian::order::native == boost::endian::order::big);
  return Refusal::kNone;
}

// Width or height of the region of interest in sensor pixels, or the full size without a region.
std::uint64_t shownPixels(std::uint32_t full, std::uint32_t roi) { return roi == 0 ? full : roi; }

std::uint64_t binningOf(std::uint32_t binning) { return std::max<std::uint32_t>(binning, 1); }

// With binning, drivers round an odd size up or down.
bool sizeFits(std::uint64_t image, std::uint64_t shown, std::uint64_t binning) {
  const std::uint64_t covered = image * binning;
  return (covered > shown ? covered - shown : shown - covered) < binning;
}

bool hasProjection(const sensor_msgs::CameraInfo& info) { return info.P[0] != 0.0 || info.P[5] != 0.0; }

// K and P refer to the full sensor; the model applies the region of interest, then the binning. It gets
// neither header nor distortion, which it would copy: a malformed message can hold any number of
// coefficients.
image_geometry::PinholeCameraModel pinholeModel(const sensor_msgs::CameraInfo& info) {
  sensor_msgs::CameraInfo pinhole;
  pinhole.K = info.K;
  pinhole.P = info.P;
  pinhole.binning_x = info.binning_x;
  pinhole.binning_y = info.binning_y;
  // Along an axis without a region of interest the full sensor is shown, whatever the offset.
  if (info.roi.width != 0) pinhole.roi.x_offset = info.roi.x_offset;
  if (info.roi.height != 0) pinhole.roi.y_offset = info.roi.y_offset;
  image_geometry::PinholeCameraModel model;
  model.fromCameraInfo(pinhole);
  return model;
}

Refusal makeCamera(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info, Validation& found) {
  if (!sizesMatch(image, info)) return Refusal::kInfoMismatch;

  found.intrinsics_from_k = !hasProjection(info);
  found.camera = found.intrinsics_from_k ? rawIntrinsics(info) : rectifiedIntrinsics(info);
  if (!isUsable(found.camera)) return Refusal::kNoIntrinsics;

  found.distorted = std::any_of(info.D.begin(), info.D.end(), [](double d) { return d != 0.0; });
  return Refusal::kNone;
}

std::string quoted(const std::string& text) { return "'" + printableText(text, 32) + "'"; }

std::string toText(double number) {
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

std::string sizeOf(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

bool sizesMatch(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info) {
  return sizeFits(image.width, shownPixels(info.width, info.roi.width), binningOf(info.binning_x)) &&
         sizeFits(image.height, shownPixels(info.height, info.roi.height), binningOf(info.binning_y));
}

CameraIntrinsics rawIntrinsics(const sensor_msgs::CameraInfo& info) {
  const image_geometry::PinholeCameraModel model = pinholeModel(info);
  const cv::Matx33d& k = model.intrinsicMatrix();
  return {k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
}

CameraIntrinsics rectifiedIntrinsics(const sensor_msgs::CameraInfo& info) {
  const image_geometry::PinholeCameraModel model = pinholeModel(info);
  return {model.fx(), model.fy(), model.cx(), model.cy()};
}

bool isUsable(const CameraIntrinsics& camera) {
  return camera.isValid() && std::min(camera.fx, camera.fy) >= kMinFocalLength &&
         std::max(camera.fx, camera.fy) <= kMaxPixelNumber &&
         std::max(std::abs(camera.cx), std::abs(camera.cy)) <= kMaxPixelNumber;
}

const char* nameOf(Refusal refusal) {
  constexpr std::array<const char*, kRefusalCount> kNames = {
      "none",         "empty_image",   "encoding",      "too_large", "bad_step",
      "short_data",   "info_mismatch", "no_intrinsics", "tf",        "unorganized",
      "cloud_fields", "not_pinhole",   "undecodable"};
  return kNames[static_cast<std::size_t>(refusal)];
}

Validation validate(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info,
                    const InputLimits& limits) {
  Validation found;
  found.refusal = makeView(image, limits, found.view);
  if (found.accepted()) found.refusal = makeCamera(image, info, found);
  if (!found.accepted()) found.view = DepthView{};
  return found;
}

std::string explain(Refusal refusal, const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info) {
  const std::string size = sizeOf(image.width, image.height);
  switch (refusal) {
    case Refusal::kEmptyImage:
      return "the image is " + size + " pixels: check the camera driver";
    case Refusal::kEncoding:
      return "encoding " + quoted(image.encoding) +
             " is no depth image: remap depth/image_rect to a topic of 16UC1, mono16 or 32FC1 images";
    case Refusal::kTooLarge:
      return "an image of " + size + " pixels with rows of " + std::to_string(image.step) +
             " bytes is too large: raise ~max_pixels if it is meant";
    case Refusal::kBadStep:
      return "rows of " + std::to_string(image.step) + " bytes cannot hold " + std::to_string(image.width) +
             " pixels of " + quoted(image.encoding) + ": check the camera driver";
    case Refusal::kShortData:
      return "the image holds " + std::to_string(image.data.size()) + " bytes, its header says " +
             std::to_string(std::uint64_t{image.height} * image.step) + ": check the camera driver";
    case Refusal::kInfoMismatch:
      return "the image is " + size + ", camera_info is about " + sizeOf(info.width, info.height) +
             " (binning " + sizeOf(info.binning_x, info.binning_y) + ", region of interest " +
             sizeOf(info.roi.width, info.roi.height) + "): publish the camera_info of this image's size";
    case Refusal::kNoIntrinsics:
      return "camera_info holds no usable focal lengths (P " + toText(info.P[0]) + ", " + toText(info.P[5]) +
             "; K " + toText(info.K[0]) + ", " + toText(info.K[4]) + "): calibrate the camera";
    case Refusal::kUndecodable:
      return "the pixels of a compressed image of " + size + ", " + quoted(image.encoding) +
             ", cannot be decoded: check the recording, or what compresses the images";
    default:  // accepted, or unrelated to the messages
      return {};
  }
}

}  // namespace line_plane_segmentation
