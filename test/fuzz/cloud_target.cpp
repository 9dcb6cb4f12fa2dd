// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>

#include "drawn_scene.h"
#include "frame_run.h"
#include "message_fields.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

CameraFrame drawFrame(ByteReader& bytes) {
  sensor_msgs::PointCloud2 cloud;
  if (bytes.chance(128)) {
    cloud = cloudOf(drawScene(bytes), bytes);
    alterFields(bytes, cloud);
  } else {
    FieldReader reader(bytes);
    visitFields(cloud, reader);
  }
  CameraFrame frame;
  frame.cloud = boost::make_shared<sensor_msgs::PointCloud2>(cloud);
  return frame;
}

}  // namespace

void tryCloud(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const CameraFrame first = drawFrame(bytes);
  FrameRun run(bytes);
  run.process(first, bytes);
  if (bytes.chance(64)) run.process(drawFrame(bytes), bytes);
  run.expectRepeatable(first);
}

}  // namespace line_plane_segmentation
