// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "conversions.h"
#include "depth_rectifier.h"
#include "image_validation.h"
#include "input_frame.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"

namespace line_plane_segmentation {

/// Computes the planes of one frame from its messages, without topics, threads or log output. Shared by the
/// nodelet and segment_bag, so that both give the same result. The result does not depend on earlier
/// frames. Not thread-safe.
class FrameSegmenter {
 public:
  explicit FrameSegmenter(const InputLimits& limits = {}) : limits_(limits) {}

  /// Sets the parameters for the next frames.
  void setParameters(const Parameters& parameters) { segmenter_.setParameters(parameters); }

  /// Validates the messages of a frame.
  /// @param frame  its messages must outlive the results computed from them
  const Validation& accept(const InputFrame& frame);

  /// Returns one line for the user if the last frame was refused: the reason and the remedy.
  /// @param frame  the frame that was passed to accept()
  std::string explanation(const InputFrame& frame) const;

  /// Segments the frame that was accepted.
  const Segmentation& segment();

  /// Gives up the current frame and all later ones, whose segmentations are empty. May be called from any
  /// thread.
  void stop() { *clock_.is_stopped = true; }
  bool isStopped() const { return *clock_.is_stopped; }

  /// Calls accept() and, unless the frame is refused, segment().
  const Validation& segment(const InputFrame& frame);

  /// Validation of the last frame. The functions below are meaningful only if it was accepted.
  const Validation& input() const { return input_; }

  /// Returns the image's header. The frame_id has no leading slashes, which tf2 refuses.
  const std_msgs::Header& header() const { return header_; }

  const Segmentation& segmentation() const { return *segmentation_; }
  /// Returns the line segments of the last frame. Computed by the first call after a frame.
  const std::vector<LineSegment>& lineSegments() { return segmenter_.lineSegments(); }
  /// Returns the candidates of the last frame. Computed by the first call after a frame.
  const std::vector<PlaneCandidate>& candidates() { return segmenter_.candidates(); }
  const DepthRange& range() const { return range_; }
  const StageClock& clock() const { return clock_; }

  /// Returns the data from which messages are built, valid until the next frame.
  /// @param published  result of publishPlanes() for this segmentation; must outlive the returned value
  SegmentedFrame result(const PublishedPlanes& published) const;

 private:
  /// Clock of the stages that can end a frame early.
  struct StoppableClock : StageClock {
    bool isStopRequested() override { return *is_stopped; }
    std::unique_ptr<std::atomic<bool>> is_stopped = std::make_unique<std::atomic<bool>>(false);  // movable
  };

  Validation acceptImage(const InputFrame& frame);
  Validation acceptCompressed(const InputFrame& frame);

  InputLimits limits_;
  PlaneSegmenter segmenter_;
  StoppableClock clock_;
  std_msgs::Header header_;
  std::vector<std::uint8_t> cloud_depth_;  // memory of the view of a cloud
  sensor_msgs::Image decoded_;             // memory of the view of a compressed image
  DepthRectifier rectifier_;
  Validation input_;
  DepthRange range_;
  const Segmentation* segmentation_ = nullptr;
};

}  // namespace line_plane_segmentation
