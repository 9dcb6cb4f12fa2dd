// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>

#include "drawn_scene.h"
#include "frame_run.h"
#include "message_fields.h"
#include "targets.h"

namespace line_plane_segmentation {
namespace {

InputFrame drawFrame(ByteReader& bytes) {
  sensor_msgs::PointCloud2 cloud;
  if (bytes.chance(128)) {
    cloud = cloudOf(drawScene(bytes), bytes);
    alterFields(bytes, cloud);
  } else {
    readFields(bytes, cloud);
  }
  InputFrame frame;
  frame.cloud = boost::make_shared<sensor_msgs::PointCloud2>(cloud);
  return frame;
}

}  // namespace

void tryCloud(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  tryFrames(bytes, drawFrame);
}

}  // namespace line_plane_segmentation
