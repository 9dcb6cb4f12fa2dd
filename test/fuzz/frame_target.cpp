// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>

#include "drawn_scene.h"
#include "frame_run.h"
#include "message_fields.h"
#include "ros/test_messages.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

CameraFrame drawFrame(ByteReader& bytes) {
  sensor_msgs::Image image;
  sensor_msgs::CameraInfo info;
  if (bytes.chance(128)) {
    const DrawnScene scene = drawScene(bytes);
    image = imageOf(scene, bytes);
    info = testInfo(scene.width, scene.height);
    alterFields(bytes, image);
    alterFields(bytes, info);
  } else {
    FieldReader reader(bytes);
    visitFields(image, reader);
    visitFields(info, reader);
  }
  CameraFrame frame;
  frame.image = boost::make_shared<sensor_msgs::Image>(image);
  frame.info = boost::make_shared<sensor_msgs::CameraInfo>(info);
  return frame;
}

}  // namespace

void tryFrame(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const CameraFrame first = drawFrame(bytes);
  FrameRun run(bytes);
  run.process(first, bytes);
  if (bytes.chance(64)) run.process(drawFrame(bytes), bytes);
  run.expectRepeatable(first);
}

}  // namespace line_plane_segmentation
