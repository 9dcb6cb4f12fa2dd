// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <vector>

#include "image_validation.h"

namespace line_plane_segmentation {

/// A valid message, one modification of it, and the expected result of validate().
struct ValidationCase {
  const char* what;
  Refusal expected;
  std::function<void(sensor_msgs::Image&, sensor_msgs::CameraInfo&)> spoil;
};

inline void PrintTo(const ValidationCase& c, std::ostream* stream) { *stream << c.what; }

inline void setFocalLengths(sensor_msgs::CameraInfo& info, double fx, double fy) {
  info.K[0] = info.P[0] = fx;
  info.K[4] = info.P[5] = fy;
}

/// Cases for the rows of doc/reliability.md that concern messages, for a 16UC1 image without padding.
inline const std::vector<ValidationCase>& validationCases() {
  using sensor_msgs::CameraInfo;
  using sensor_msgs::Image;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::uint32_t kMaxUint32 = std::numeric_limits<std::uint32_t>::max();
  static const std::vector<ValidationCase> kCases = {
      {"as a camera sends it", Refusal::kNone, [](Image&, CameraInfo&) {}},

      {"row 1: width 0", Refusal::kEmptyImage, [](Image& i, CameraInfo&) { i.width = 0; }},
      {"row 1: height 0", Refusal::kEmptyImage, [](Image& i, CameraInfo&) { i.height = 0; }},
      {"row 1: a default message", Refusal::kEmptyImage,
       [](Image& i, CameraInfo& c) {
         i = Image();
         c = CameraInfo();
       }},

      {"row 2: no data", Refusal::kShortData, [](Image& i, CameraInfo&) { i.data.clear(); }},
      {"row 2: one byte short", Refusal::kShortData, [](Image& i, CameraInfo&) { i.data.pop_back(); }},
      {"row 2: longer than needed", Refusal::kNone,
       [](Image& i, CameraInfo&) { i.data.resize(i.data.size() + 7); }},

      {"row 3: step one byte short", Refusal::kBadStep, [](Image& i, CameraInfo&) { --i.step; }},
      {"row 3: step 0", Refusal::kBadStep, [](Image& i, CameraInfo&) { i.step = 0; }},
      {"row 3: step of 16 bits under 32FC1", Refusal::kBadStep,
       [](Image& i, CameraInfo&) { i.encoding = "32FC1"; }},

      {"row 4: height * step wraps to 0", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = 1;
         i.height = 65536;
         i.step = 65536;
         i.data.clear();
       }},
      {"row 4: width * height wraps to 0", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = i.height = 65536;
         i.step = 2 * 65536;
         i.data.clear();
       }},
      {"row 4: everything at its largest", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) { i.width = i.height = i.step = kMaxUint32; }},
      {"row 4: more than max_pixels", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = 4097;
         i.height = 4096;
         i.step = 2 * 4097;
       }},
      {"row 4: 2 * width wraps to 0", Refusal::kTooLarge,
       [](Image& i, CameraInfo&) {
         i.width = 0x80000000U;
         i.height = 1;
         i.step = 0;
       }},

      {"row 5: padded rows", Refusal::kNone,
       [](Image& i, CameraInfo&) {
         i.step += 3;
         i.data.resize(std::size_t{i.step} * i.height);
       }},

      {"row 6: rgb8", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding = "rgb8"; }},
      {"row 6: 8UC1", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding = "8UC1"; }},
      {"row 6: 64FC1", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding = "64FC1"; }},
      {"row 6: no encoding", Refusal::kEncoding, [](Image& i, CameraInfo&) { i.encoding.clear(); }},
      {"row 6: garbage", Refusal::kEncoding,
       [](Image& i, CameraInfo&) { i.encoding.assign(100000, '\x01'); }},
      {"row 7: mono16", Refusal::kNone, [](Image& i, CameraInfo&) { i.encoding = "mono16"; }},
      {"row 8: big-endian", Refusal::kNone, [](Image& i, CameraInfo&) { i.is_bigendian = 1; }},

      {"row 15: K and P zero", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) {
         c.K.fill(0.0);
         c.P.fill(0.0);
       }},
      {"row 16: P zero", Refusal::kNone, [](Image&, CameraInfo& c) { c.P.fill(0.0); }},
      {"row 16: P zero but for its scale", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.P.fill(0.0);
         c.P[10] = 1.0;
       }},
      {"row 17: fx NaN", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, kNan, 525.0); }},
      {"row 17: fy NaN", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, kNan); }},
      {"row 17: fx infinite", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, kInf, 525.0); }},
      {"row 17: fy -infinite", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, -kInf); }},
      {"row 17: fx 0", Refusal::kNoIntrinsics, [](Image&, CameraInfo& c) { setFocalLengths(c, 0.0, 525.0); }},
      {"row 17: fy negative", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, -525.0); }},
      {"row 17: fx so small that points are infinite", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 1e-310, 525.0); }},
      {"row 17: fy beyond all lenses", Refusal::kNoIntrinsics,
       [](Image&, CameraInfo& c) { setFocalLengths(c, 525.0, 1e300); }},
      {"row 17: cx NaN", Refusal::kNoIntrinsics, [](Image&, CameraInfo& c) { c.P[2] = kNan; }},
      {"row 17: cy infinite", Refusal::kNoIntrinsics, [](Image&, CameraInfo& c) { c.P[6] = kInf; }},
      {"row 17: axis outside the image", Refusal::kNone, [](Image&, CameraInfo& c) { c.P[2] = -40.0; }},

      {"row 18: info of another width", Refusal::kInfoMismatch, [](Image&, CameraInfo& c) { c.width *= 2; }},
      {"row 18: info of another height", Refusal::kInfoMismatch, [](Image&, CameraInfo& c) { --c.height; }},
      {"row 18: info without a size", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) { c.width = c.height = 0; }},
      {"row 18: binned", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.width *= 2;
         c.height *= 2;
         c.binning_x = c.binning_y = 2;
       }},
      {"row 18: binned, odd size rounded down", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.width = 2 * c.width + 1;
         c.binning_x = 2;
       }},
      {"row 18: binned, odd size rounded up", Refusal::kNone,
       [](Image&, CameraInfo& c) {
         c.width = 2 * c.width - 1;
         c.binning_x = 2;
       }},
      {"row 18: binning that does not fit", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) { c.binning_x = 2; }},
      {"row 18: binning at its largest", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) { c.binning_x = c.binning_y = kMaxUint32; }},
      {"row 18: region of interest", Refusal::kNone,
       [](Image& i, CameraInfo& c) {
         c.roi.width = i.width;
         c.roi.height = i.height;
         c.roi.x_offset = 100;
         c.roi.y_offset = 50;
         c.width = 640;
         c.height = 480;
       }},
      {"row 18: region of interest of another size", Refusal::kInfoMismatch,
       [](Image&, CameraInfo& c) {
         c.roi.width = 5;
         c.roi.height = 5;
       }},

      {"row 19: distorted", Refusal::kNone, [](Image&, CameraInfo& c) { c.D[0] = 0.1; }},
      {"row 19: no distortion given", Refusal::kNone, [](Image&, CameraInfo& c) { c.D.clear(); }},
      {"row 25: no frame_id", Refusal::kNone, [](Image& i, CameraInfo&) { i.header.frame_id.clear(); }},
      {"row 25: frame_id with a slash", Refusal::kNone,
       [](Image& i, CameraInfo&) { i.header.frame_id = "/camera"; }},
      {"row 25: frame_id with two slashes", Refusal::kNone,
       [](Image& i, CameraInfo&) { i.header.frame_id = "//camera"; }},
  };
  return kCases;
}

}  // namespace line_plane_segmentation
