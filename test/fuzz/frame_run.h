// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2/buffer_core.h>

#include "byte_reader.h"
#include "frame_segmenter.h"
#include "plane_locator.h"

namespace line_plane_segmentation {

/// The way of frames through the nodelet, without topics and threads; expects at every step what is promised.
class FrameRun {
 public:
  /// Draws the parameters.
  explicit FrameRun(ByteReader& bytes);
  explicit FrameRun(const Parameters& parameters);

  /// @param bytes  from which come the places that tf tells
  void process(const InputFrame& frame, ByteReader& bytes);

  /// Expects that the frame comes out the same here and in a segmenter that has seen nothing before.
  void expectRepeatable(const InputFrame& frame);

 private:
  Parameters parameters_;
  FrameSegmenter segmenter_;
  PlaneLocator locator_;
};

/// The frame of an image and its camera_info.
InputFrame frameOf(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info);

/// A frame, sometimes two, as `draw` makes them of the bytes, with parameters from the bytes.
void tryFrames(ByteReader& bytes, InputFrame (*draw)(ByteReader&));

}  // namespace line_plane_segmentation
