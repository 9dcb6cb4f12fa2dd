// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_scene.h"
#include "frame_run.h"
#include "message_fields.h"
#include "ros/test_messages.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

InputFrame drawFrame(ByteReader& bytes) {
  sensor_msgs::Image image;
  sensor_msgs::CameraInfo info;
  if (bytes.chance(128)) {
    const DrawnScene scene = drawScene(bytes);
    image = imageOf(scene, bytes);
    info = testInfo(scene.width, scene.height);
    alterFields(bytes, image);
    alterFields(bytes, info);
  } else {
    readFields(bytes, image, info);
  }
  return frameOf(image, info);
}

}  // namespace

void tryFrame(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  tryFrames(bytes, drawFrame);
}

}  // namespace line_plane_segmentation
