// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <cstddef>
#include <string>

namespace line_plane_segmentation {

constexpr std::size_t kLongestFrameName = 255;

/// Returns text of unknown origin, made fit for a log: cut off after so many characters, and printable.
inline std::string shortText(const std::string& text, std::size_t longest = 64) {
  std::string shown = text.substr(0, longest);
  for (char& c : shown) {
    if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
  }
  return text.size() > longest ? shown + "..." : shown;
}

}  // namespace line_plane_segmentation
