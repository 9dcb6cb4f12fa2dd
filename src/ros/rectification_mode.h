// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace line_plane_segmentation {

/// Values of ~rectify: rectification of images whose camera_info has distortion.
enum class RectificationMode {
  kNever,   ///< images are used as they are
  kAlways,  ///< images are raw and are rectified
  kAuto,    ///< images are raw unless the last part of their topic contains "rect", as image_rect
};

/// Returns the mode of "false", "true" or "auto"; empty for another name.
inline std::optional<RectificationMode> rectificationModeOf(const std::string& name) {
  if (name == "false") return RectificationMode::kNever;
  if (name == "true") return RectificationMode::kAlways;
  if (name == "auto") return RectificationMode::kAuto;
  return {};
}

/// Returns true if the images of a topic are to be rectified.
inline bool needsRectification(RectificationMode rectify, const std::string& image_topic) {
  if (rectify != RectificationMode::kAuto) return rectify == RectificationMode::kAlways;
  return image_topic.substr(image_topic.rfind('/') + 1).find("rect") == std::string::npos;
}

}  // namespace line_plane_segmentation
