// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace line_plane_segmentation {

/// Whether images are rectified here, if camera_info tells of distortion.
enum class Rectify {
  kNever,
  kAlways,
  kAuto,  ///< unless the name of the image's topic says that they are rectified already, as image_rect does
};

/// Returns the value of "false", "true" or "auto"; nothing for another name.
inline std::optional<Rectify> rectifyOf(const std::string& name) {
  if (name == "false") return Rectify::kNever;
  if (name == "true") return Rectify::kAlways;
  if (name == "auto") return Rectify::kAuto;
  return {};
}

/// Returns whether the images of a topic are to be rectified.
inline bool isRaw(Rectify rectify, const std::string& image_topic) {
  if (rectify != Rectify::kAuto) return rectify == Rectify::kAlways;
  return image_topic.substr(image_topic.rfind('/') + 1).find("rect") == std::string::npos;
}

}  // namespace line_plane_segmentation
