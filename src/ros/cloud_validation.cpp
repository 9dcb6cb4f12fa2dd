// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_validation.h"

#include <sensor_msgs/PointField.h>

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <cstring>
#include <limits>

namespace line_plane_segmentation {
namespace {

// Finds the offset of a float coordinate that lies completely within the point.
bool findOffset(const sensor_msgs::PointCloud2& cloud, const char* name, std::size_t& offset) {
  for (const sensor_msgs::PointField& field : cloud.fields) {
    if (field.name != name) continue;
    offset = field.offset;
    return field.datatype == sensor_msgs::PointField::FLOAT32 && offset + sizeof(float) <= cloud.point_step;
  }
  return false;
}

const char* nameOfType(std::uint8_t datatype) {
  constexpr std::array<const char*, 9> kNames = {"of no type", "INT8",   "UINT8",   "INT16",  "UINT16",
                                                 "INT32",      "UINT32", "FLOAT32", "FLOAT64"};
  return datatype < kNames.size() ? kNames[datatype] : kNames[0];
}

// Describes invalid coordinate fields: "x is FLOAT64, there is no z".
std::string describeFields(const sensor_msgs::PointCloud2& cloud) {
  std::string text;
  for (const char* name : {"x", "y", "z"}) {
    std::size_t offset = 0;
    if (findOffset(cloud, name, offset)) continue;
    const auto field =
        std::find_if(cloud.fields.begin(), cloud.fields.end(),
                     [name](const sensor_msgs::PointField& other) { return other.name == name; });
    text += text.empty() ? "" : ", ";
    if (field == cloud.fields.end()) {
      text += std::string("there is no ") + name;
    } else if (field->datatype != sensor_msgs::PointField::FLOAT32) {
      text += std::string(name) + " is " + nameOfType(field->datatype);
    } else {
      text += std::string(name) + " lies outside of its point";
    }
  }
  return text;
}

std::string sizeOf(const sensor_msgs::PointCloud2& cloud) {
  return std::to_string(cloud.width) + "x" + std::to_string(cloud.height);
}

}  // namespace

Refusal viewOf(const sensor_msgs::PointCloud2& cloud, const InputLimits& limits, CloudView& view) {
  if (cloud.width == 0 || cloud.height == 0) return Refusal::kEmptyImage;
  if (cloud.height == 1) return Refusal::kUnorganized;
  const std::uint64_t width = cloud.width;
  const std::uint64_t height = cloud.height;
  const std::uint64_t most = std::min<std::uint64_t>(limits.max_pixels, std::numeric_limits<int>::max());
  // 32-bit values cannot overflow when multiplied in 64 bits.
  if (width * height > most) return Refusal::kTooLarge;

  CloudView found;
  if (!findOffset(cloud, "x", found.x) || !findOffset(cloud, "y", found.y) ||
      !findOffset(cloud, "z", found.z)) {
    return Refusal::kCloudFields;
  }
  if (cloud.row_step < width * cloud.point_step) return Refusal::kBadStep;
  if (cloud.data.size() < height * cloud.row_step) return Refusal::kShortData;
  found.data = cloud.data.data();
  found.width = static_cast<int>(width);
  found.height = static_cast<int>(height);
  found.row_step = cloud.row_step;
  found.point_step = cloud.point_step;
  found.swap_bytes = (cloud.is_bigendian != 0) != (boost::endian::order::native == boost::endian::order::big);
  view = found;
  return Refusal::kNone;
}

Validation validate(const sensor_msgs::PointCloud2& cloud, const InputLimits& limits,
                    std::vector<std::uint8_t>& depth) {
  constexpr double kRounded = 0.5;  // [px] largest residual of a camera without distortion
  Validation found;
  CloudView view;
  found.refusal = viewOf(cloud, limits, view);
  if (!found.accepted()) return found;
  const CloudCamera fit = cameraOf(view);
  found.refusal = fit.refusal;
  if (!found.accepted()) return found;
  found.camera = fit.camera;
  found.distorted = fit.deviation > kRounded;

  const std::size_t step = sizeof(float) * static_cast<std::size_t>(view.width);
  depth.resize(step * static_cast<std::size_t>(view.height));
  std::uint8_t* to = depth.data();
  for (int v = 0; v < view.height; ++v) {
    const std::uint8_t* from = view.data + static_cast<std::size_t>(v) * view.row_step + view.z;
    for (int u = 0; u < view.width; ++u, from += view.point_step, to += sizeof(float)) {
      std::memcpy(to, from, sizeof(float));
    }
  }
  found.view = {depth.data(), view.width, view.height, step, DepthType::kFloat32, 1.0F, view.swap_bytes};
  return found;
}

std::string explain(Refusal refusal, const sensor_msgs::PointCloud2& cloud) {
  switch (refusal) {
    case Refusal::kEmptyImage:
      return "the cloud is " + sizeOf(cloud) + " points: check the camera driver";
    case Refusal::kUnorganized:
      return "the cloud is unorganized, a list of " + std::to_string(cloud.width) +
             " points: an organized one is needed, with a point for every pixel, such as "
             "depth_registered/points";
    case Refusal::kTooLarge:
      return "a cloud of " + sizeOf(cloud) + " points is too large: raise ~max_pixels if it is meant";
    case Refusal::kCloudFields:
      return "the cloud's points have no x, y and z that are FLOAT32 (" + describeFields(cloud) +
             "): convert it, or check the camera driver";
    case Refusal::kBadStep:
      return "rows of " + std::to_string(cloud.row_step) + " bytes cannot hold " +
             std::to_string(cloud.width) + " points of " + std::to_string(cloud.point_step) +
             " bytes: check the camera driver";
    case Refusal::kShortData:
      return "the cloud holds " + std::to_string(cloud.data.size()) + " bytes, its header says " +
             std::to_string(std::uint64_t{cloud.height} * cloud.row_step) + ": check the camera driver";
    case Refusal::kNotPinhole:
      return "the cloud's points are not where a pinhole camera sees its pixels: it must be that of one "
             "depth camera, "
             "in the camera's own optical frame (x right, y down, z ahead), not transformed";
    default:  // accepted, or unrelated to the cloud
      return {};
  }
}

}  // namespace line_plane_segmentation
