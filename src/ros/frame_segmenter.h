// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <string>
#include <vector>

#include "camera_frame.h"
#include "depth_rectifier.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/ros/conversions.h"
#include "line_plane_segmentation/ros/image_validation.h"
#include "line_plane_segmentation/stage_clock.h"

namespace line_plane_segmentation {

/// From the messages of one frame to its planes, without topics, threads or log: what the nodelet and the
/// tools for bags share, so that they give the same. Knows nothing of the frames before; not thread-safe.
class FrameSegmenter {
 public:
  explicit FrameSegmenter(const InputLimits& limits = {}) : limits_(limits) {}

  /// Takes effect with the next frame.
  void setParameters(const Parameters& parameters) { segmenter_.setParameters(parameters); }

  /// Looks at the frame, and decides whether it is segmented.
  /// @param frame  its messages must live as long as what is made of them here
  const Validation& accept(const CameraFrame& frame);

  /// One line for the user, if the last frame was refused: why, and what to do about it.
  /// @param frame  the same that was looked at
  std::string explanation(const CameraFrame& frame) const;

  /// Segments the frame that was accepted.
  const Segmentation& segment();

  /// Both in one, unless the frame is refused.
  const Validation& segment(const CameraFrame& frame);

  /// Of the last frame: what was decided about it. The rest below is meaningful only if it was accepted.
  const Validation& input() const { return input_; }

  /// The image's header, its frame_id without the leading slashes that tf2 refuses.
  const std_msgs::Header& header() const { return header_; }

  const Segmentation& segmentation() const { return *segmentation_; }
  const std::vector<LineSegment>& lineSegments() const { return segmenter_.lineSegments(); }
  const std::vector<PlaneCandidate>& candidates() const { return segmenter_.candidates(); }
  const DepthRange& range() const { return range_; }
  const StageClock& clock() const { return clock_; }

  /// All that messages are made from, valid until the next frame.
  /// @param published  what publishPlanes() made of the segmentation; must live as long
  SegmentedFrame result(const PublishedPlanes& published) const;

 private:
  Validation acceptImage(const CameraFrame& frame);
  Validation acceptCompressed(const CameraFrame& frame);

  InputLimits limits_;
  PlaneSegmenter segmenter_;
  StageClock clock_;
  std_msgs::Header header_;
  std::vector<std::uint8_t> cloud_depth_;  // what the view of a cloud shows
  sensor_msgs::Image decoded_;             // what the view of a compressed image shows
  DepthRectifier rectifier_;
  Validation input_;
  DepthRange range_;
  const Segmentation* segmentation_ = nullptr;
};

}  // namespace line_plane_segmentation
