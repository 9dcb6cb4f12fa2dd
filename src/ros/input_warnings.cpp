// SPDX-License-Identifier: BSD-3-Clause
#include "input_warnings.h"

#include <ros/console.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "printable_text.h"

namespace line_plane_segmentation {
namespace {

bool startsWithSlash(const std::string& frame_id) { return !frame_id.empty() && frame_id.front() == '/'; }

}  // namespace

bool InputWarnings::isDue(TimePoint& last) {
  constexpr std::chrono::seconds kPause(5);
  const TimePoint now = std::chrono::steady_clock::now();
  if (last != TimePoint{} && now - last < kPause) return false;
  last = now;
  return true;
}

void InputWarnings::warnOnce(bool& warned, const std::string& text) {
  if (!warned) ROS_WARN("[%s] %s", name_.c_str(), text.c_str());
  warned = true;
}

void InputWarnings::countLookup(TransformPurpose purpose, const TransformLookup& lookup, double patience) {
  constexpr std::array<const char*, kTransformPurposeCount> kWhatFails = {
      "~target_frame, so that the frames are refused", "~gravity_frame, so that orientations are unknown",
      "~fixed_frame, so that ids go by the images alone"};
  constexpr int kFewest = 5;
  constexpr int kMost = 100;  // older lookups lose weight beyond this count
  Transforms& count = transforms_[static_cast<std::size_t>(purpose)];
  if (count.found + count.failed >= kMost) count = {count.found / 2, count.failed / 2, count.last_warning};
  ++(lookup.found() ? count.found : count.failed);
  if (lookup.found() || count.failed < kFewest || count.failed <= count.found) return;
  if (!isDue(count.last_warning)) return;
  ROS_WARN("[%s] in %d %% of the frames tf does not know %s. Is it published? %s", name_.c_str(),
           100 * count.failed / (count.found + count.failed), kWhatFails[static_cast<std::size_t>(purpose)],
           explain(lookup, patience).c_str());
}

void InputWarnings::warnAboutRefusal(Refusal refusal, const std::string& explanation) {
  if (isDue(last_refused_[static_cast<std::size_t>(refusal)])) {
    ROS_WARN("[%s] refused a frame (%s): %s", name_.c_str(), nameOf(refusal), explanation.c_str());
  }
}

void InputWarnings::warnAboutFailure(const std::string& problem) {
  if (isDue(last_failed_)) ROS_ERROR("[%s] a frame failed: %s", name_.c_str(), problem.c_str());
}

void InputWarnings::checkFrame(const InputFrame& frame, const Validation& input) {
  if (input.intrinsics_from_k)
    warnOnce(warned_intrinsics_from_k_, "camera_info has no P: K is used in its place");
  if (input.distorted) {
    warnOnce(warned_distorted_,
             frame.cloud ? "the clouds come from a camera with distortion: planes bend toward the borders"
                         : "camera_info has distortion: unless the images are rectified, planes bend "
                           "toward their borders. ~rectify: true rectifies them here");
  }
  const std::string& image_frame = frame.header().frame_id;
  if (image_frame.empty())
    warnOnce(warned_no_frame_, "the images have no frame_id: rviz and tf cannot place them");
  if (startsWithSlash(image_frame)) {
    warnOnce(warned_slash_, "the images' frame_id '" + printableText(image_frame) +
                                "' starts with a slash, which tf2 refuses: it is cut off");
  }
  if (frame.cloud) return;
  const std::string& info_frame = frame.info->header.frame_id;
  if (info_frame != image_frame) {
    warnOnce(warned_other_frame_, "camera_info has frame_id '" + printableText(info_frame) +
                                      "', the images have '" + printableText(image_frame) +
                                      "': that of the images counts");
  }
}

void InputWarnings::checkSegmentation(const Validation& input, const DepthRange& range,
                                      const Segmentation& segmentation) {
  constexpr int kImages = 30;
  const std::size_t pixels = segmentation.labels.size();
  const std::size_t with_depth = segmentation.valid_pixels;
  if (2 * with_depth < pixels) {
    if (!warned_out_of_range_) warnAboutRange(input.view, range);
    return;
  }
  without_plane_ = segmentation.planes.empty() ? without_plane_ + 1 : 0;
  if (without_plane_ < kImages) return;
  warnOnce(warned_no_plane_,
           std::to_string(100 * with_depth / pixels) +
               " % of the pixels have depth, but no plane was found in " + std::to_string(kImages) +
               " images. " +
               "Is ~depth_unit right, and camera_info that of these images? Otherwise lower "
               "~min_plane_inliers, or raise ~noise_growth for a noisier camera");
}

void InputWarnings::warnAboutRange(const DepthView& depth, const DepthRange& range) {
  const OutOfRange fractions = fractionsOutOfRange(depth, range);
  if (fractions.near + fractions.beyond <= 0.5) return;
  std::ostringstream text;
  text << std::lround(100.0 * (fractions.near + fractions.beyond))
       << " % of the depths are below ~min_range (" << range.min << " m) or beyond ~max_range (" << range.max
       << " m): ";
  if (depth.type == DepthType::kUint16) {
    text << "is ~depth_unit (" << depth.depth_unit << " m) right?";
  } else {
    text << (fractions.beyond > fractions.near ? "are they in millimetres?" : "are they in metres?");
  }
  warnOnce(warned_out_of_range_, text.str());
}

OutOfRange fractionsOutOfRange(const DepthView& depth, const DepthRange& range) {
  constexpr int kRowStep = 16;
  const DepthRange any{0.0F, std::numeric_limits<float>::max()};
  std::vector<float> row(static_cast<std::size_t>(depth.width));
  std::size_t with_depth = 0;
  std::size_t near = 0;
  std::size_t beyond = 0;
  for (int v = 0; v < depth.height; v += kRowStep) {
    loadRow(depth, v, any, row.data());
    for (const float z : row) {
      if (z <= 0.0F) continue;
      ++with_depth;
      if (z <= range.min) ++near;
      if (z >= range.max) ++beyond;
    }
  }
  if (with_depth == 0) return {};
  const auto all = static_cast<double>(with_depth);
  return {static_cast<double>(near) / all, static_cast<double>(beyond) / all};
}

}  // namespace line_plane_segmentation
