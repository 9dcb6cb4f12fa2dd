// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "frame_statistics.h"
#include "input_source.h"

namespace line_plane_segmentation {

/// State of the nodelet, from which its diagnostics are written.
struct NodeletStatus {
  std::string failure;      ///< reason why the nodelet does not run; empty if it runs
  bool subscribed = false;  ///< true if an output has a subscriber
  InputTopics topics;
  InputTimes input;
  std::uint64_t dropped = 0;        ///< dropped frames since the start
  std::uint64_t newly_dropped = 0;  ///< dropped frames since the last report
  std::uint64_t lost = 0;           ///< images without a camera_info of their timestamp, since the start
  std::uint64_t newly_lost = 0;     ///< the same since the last report
  std::uint64_t newly_late = 0;     ///< lost images whose camera_info arrived later, since the last report
  std::chrono::steady_clock::duration time_in_frame{};  ///< processing time of the current frame so far
  FrameReport frames;
};

/// Writes the diagnostics: level, one sentence for the user, and all figures.
void report(const NodeletStatus& status, InputTimes::TimePoint now,
            diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace line_plane_segmentation
