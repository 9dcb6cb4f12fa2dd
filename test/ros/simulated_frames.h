// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "simulated_camera.h"
#include "test_messages.h"

namespace line_plane_segmentation {

/// Messages of a depth camera at one time.
struct TestFrame {
  sensor_msgs::Image image;
  sensor_msgs::CameraInfo info;
};

/// Renders `count` images, one second apart, of a simulated Kinect that moves through a furnished room.
/// @param seed      of the room
/// @param encoding  16UC1, mono16 or 32FC1
inline std::vector<TestFrame> simulatedFrames(std::uint64_t seed, int count, int width, int height,
                                              const std::string& encoding = "16UC1") {
  simulation::SimulatedCamera camera({seed, width, height, true});
  const auto columns = static_cast<std::uint32_t>(width);
  const auto rows = static_cast<std::uint32_t>(height);
  std::vector<std::uint16_t> millimetres(std::size_t{columns} * rows);
  std::vector<TestFrame> frames;
  for (int i = 0; i < count; ++i) {
    camera.capture(static_cast<std::uint64_t>(i), i, millimetres.data());
    TestFrame frame{testImage(columns, rows, encoding), testInfo(columns, rows)};
    for (std::uint32_t v = 0; v < rows; ++v) {
      for (std::uint32_t u = 0; u < columns; ++u) {
        setDepth(frame.image, u, v, 0.001 * millimetres[std::size_t{v} * columns + u]);
      }
    }
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace line_plane_segmentation
