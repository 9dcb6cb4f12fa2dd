// SPDX-License-Identifier: BSD-3-Clause
#include "text_overlap.h"

#include <algorithm>
#include <sstream>

namespace line_plane_segmentation {

bool TextOverlapFilter::addIfFree(const Eigen::Vector3d& center, double height, const std::string& text) {
  // rviz's font, in heights of a capital letter.
  constexpr double kCharacterWidth = 0.6;
  constexpr double kLineSpacing = 1.3;
  if (center.z() <= 0.0) return true;

  std::size_t lines = 0, longest = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line); ++lines) longest = std::max(longest, line.size());
  const double half_width = 0.5 * kCharacterWidth * height * static_cast<double>(longest);
  const double half_height = 0.5 * kLineSpacing * height * static_cast<double>(lines);

  const Eigen::Vector2d middle(camera_.fx * center.x() / center.z() + camera_.cx,
                               camera_.fy * center.y() / center.z() + camera_.cy);
  const Eigen::Vector2d half(camera_.fx * half_width / center.z(), camera_.fy * half_height / center.z());
  const Box box{middle.x() - half.x(), middle.x() + half.x(), middle.y() - half.y(), middle.y() + half.y()};
  const bool covered = std::any_of(boxes_.begin(), boxes_.end(), [&box](const Box& other) {
    return box.left < other.right && other.left < box.right && box.top < other.bottom &&
           other.top < box.bottom;
  });
  if (!covered) boxes_.push_back(box);
  return !covered;
}

}  // namespace line_plane_segmentation
