// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace line_plane_segmentation {

/// Returns the text of a progress bar: "[======>     ]  54 %  1234 frames  143/s  0:07 left".
/// @param done      number of processed frames
/// @param fraction  of the whole work, 0 to 1
/// @param seconds   since the beginning
std::string progressText(std::size_t done, double fraction, double seconds);

/// Progress bar on stderr. If stderr is not a terminal, a line every half minute instead.
class Progress {
 public:
  Progress();

  /// Removes the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, double fraction);

  /// Removes the bar until the next update(), so that other text can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  bool on_terminal_;
  bool visible_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace line_plane_segmentation
