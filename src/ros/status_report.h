// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstdint>
#include <string>

#include "frame_statistics.h"
#include "input_source.h"

namespace line_plane_segmentation {

/// Input of the diagnostics.
struct NodeletStatus {
  std::string failure;  ///< why the nodelet does not run; empty if it runs
  bool wanted = false;  ///< an output has a subscriber
  InputTopics topics;
  InputTimes input;
  std::uint64_t dropped = 0;        ///< number of frames since the start
  std::uint64_t newly_dropped = 0;  ///< number of frames since the last report
  std::uint64_t lost = 0;           ///< images without a camera_info of their stamp, since the beginning
  std::uint64_t newly_lost = 0;     ///< the same, since the last report
  std::uint64_t newly_late = 0;     ///< lost images whose camera_info came later, since the last report
  FrameReport frames;
};

/// Writes the state of the nodelet as one sentence for the user, followed by the figures.
void report(const NodeletStatus& status, InputTimes::TimePoint now,
            diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace line_plane_segmentation
