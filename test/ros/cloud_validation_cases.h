// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/PointField.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <vector>

#include "image_validation.h"

namespace line_plane_segmentation {

/// A valid cloud, one modification of it, and the expected result of validate().
struct CloudCase {
  const char* what;
  Refusal expected;
  std::function<void(sensor_msgs::PointCloud2&)> spoil;
};

inline void PrintTo(const CloudCase& c, std::ostream* stream) { *stream << c.what; }

/// Modifications of testCloud() that make it invalid.
inline const std::vector<CloudCase>& cloudCases() {
  using sensor_msgs::PointCloud2;
  constexpr std::uint32_t kMaxUint32 = std::numeric_limits<std::uint32_t>::max();
  static const std::vector<CloudCase> kCases = {
      {"as a camera sends it", Refusal::kNone, [](PointCloud2&) {}},
      {"longer than needed", Refusal::kNone, [](PointCloud2& c) { c.data.resize(c.data.size() + 100); }},

      {"a default message", Refusal::kEmptyImage, [](PointCloud2& c) { c = PointCloud2(); }},
      {"width 0", Refusal::kEmptyImage, [](PointCloud2& c) { c.width = 0; }},
      {"height 0", Refusal::kEmptyImage, [](PointCloud2& c) { c.height = 0; }},
      {"all points in one row", Refusal::kUnorganized,
       [](PointCloud2& c) {
         c.width *= c.height;
         c.height = 1;
         c.row_step = c.width * c.point_step;
       }},
      {"width and height at their largest", Refusal::kTooLarge,
       [](PointCloud2& c) { c.width = c.height = kMaxUint32; }},

      {"no fields", Refusal::kCloudFields, [](PointCloud2& c) { c.fields.clear(); }},
      {"no z", Refusal::kCloudFields, [](PointCloud2& c) { c.fields[2].name = "intensity"; }},
      {"x of 64 bits", Refusal::kCloudFields,
       [](PointCloud2& c) { c.fields[0].datatype = sensor_msgs::PointField::FLOAT64; }},
      {"y ends beyond the point", Refusal::kCloudFields,
       [](PointCloud2& c) { c.fields[1].offset = c.point_step - 3; }},
      {"offset of y at its largest", Refusal::kCloudFields,
       [](PointCloud2& c) { c.fields[1].offset = kMaxUint32; }},
      {"point_step 0", Refusal::kCloudFields, [](PointCloud2& c) { c.point_step = 0; }},

      {"row_step one byte short", Refusal::kBadStep,
       [](PointCloud2& c) { c.row_step = c.width * c.point_step - 1; }},
      {"point_step at its largest", Refusal::kBadStep, [](PointCloud2& c) { c.point_step = kMaxUint32; }},
      {"one byte short", Refusal::kShortData, [](PointCloud2& c) { c.data.pop_back(); }},
      {"no data", Refusal::kShortData, [](PointCloud2& c) { c.data.clear(); }},
      {"row_step at its largest", Refusal::kShortData, [](PointCloud2& c) { c.row_step = kMaxUint32; }},
  };
  return kCases;
}

}  // namespace line_plane_segmentation
