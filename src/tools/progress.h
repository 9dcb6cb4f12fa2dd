// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace line_plane_segmentation {

/// The text of a progress bar: "[======>     ]  54 %  1234 frames  143/s  0:07 left".
/// @param done     frames that were worked on
/// @param share    of the whole work, 0 to 1
/// @param seconds  since the beginning
std::string progressText(std::size_t done, double share, double seconds);

/// A bar on stderr that tells how far the work is. Where stderr is no terminal, but a file, it says so in a
/// line of its own every half minute.
class Progress {
 public:
  Progress();

  /// Takes the bar away.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, double share);

  /// Takes the bar away until the next update(), so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool on_terminal_;
  bool visible_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace line_plane_segmentation
