// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "frame_mailbox.h"
#include "frame_segmenter.h"
#include "frame_statistics.h"
#include "input_warnings.h"
#include "outputs.h"
#include "parameter_config.h"
#include "plane_locator.h"
#include "processing_time.h"
#include "robot_messages.h"
#include "transform_listener.h"

namespace line_plane_segmentation {

/// Segments frames and publishes the results in a thread of its own, so that the worker threads of the
/// nodelet manager are never blocked. The public functions may be called from any thread.
class FrameProcessor {
 public:
  /// @param name  name of the nodelet, for the log
  /// @param queue_size  largest number of waiting frames
  /// @param outputs     must outlive this
  /// @param transforms  must outlive this
  FrameProcessor(const std::string& name, const InputLimits& limits, std::size_t queue_size,
                 const Outputs& outputs, TransformListener& transforms);

  /// Gives up the current frame, and ends the thread.
  ~FrameProcessor();
  FrameProcessor(const FrameProcessor&) = delete;
  FrameProcessor& operator=(const FrameProcessor&) = delete;

  /// Sets all parameters together, for the next frame. Does not wait for the current frame.
  void setParameters(const NodeletParameters& parameters);

  FrameMailbox& mailbox() { return mailbox_; }
  FrameStatistics& statistics() { return statistics_; }
  /// Time of the current frame, without waiting for transforms.
  const ProcessingTime& processingTime() const { return processing_time_; }

 private:
  void process(const InputFrame& frame);
  const Validation& accept(const InputFrame& frame);
  void applyParameters();
  CameraPoses lookUpPoses(const InputFrame& frame);
  bool mayBecomeAvailable(const CameraPoses& poses);
  bool mayWaitLonger(const InputFrame& frame);
  void warnAboutTransforms(const CameraPoses& poses);
  void refuse(Refusal refusal, const std::string& explanation);

  const Outputs& outputs_;
  const TransformListener& transforms_;
  FrameStatistics statistics_;
  ProcessingTime processing_time_;

  std::mutex parameters_mutex_;
  NodeletParameters parameters_;
  bool parameters_changed_ = true;

  // Used by the thread of the mailbox only.
  InputWarnings warnings_;
  RobotMessages robot_;
  FrameSegmenter segmenter_;
  PlaneLocator locator_;
  bool tracing_outlines_ = true;
  // Per lookup: time since which tf does not know its frames; empty if the frames are known.
  std::array<std::optional<std::chrono::steady_clock::time_point>, CameraPoses::kCount> unknown_since_;

  FrameMailbox mailbox_;  // last: its thread uses all of the above
};

}  // namespace line_plane_segmentation
