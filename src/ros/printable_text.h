// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <cstddef>
#include <string>

namespace line_plane_segmentation {

/// Largest length of a frame_id [characters]; longer ones are truncated or refused.
constexpr std::size_t kLongestFrameName = 255;

/// Makes text of a message safe for a log: truncates it and replaces unprintable characters by '?'.
/// @param longest  largest number of characters
inline std::string printableText(const std::string& text, std::size_t longest = 64) {
  std::string shown = text.substr(0, longest);
  for (char& c : shown) {
    if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
  }
  return text.size() > longest ? shown + "..." : shown;
}

}  // namespace line_plane_segmentation
