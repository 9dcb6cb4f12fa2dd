// SPDX-License-Identifier: BSD-3-Clause
#include "processing_time.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace line_plane_segmentation {
namespace {

TEST(ProcessingTime, IsThatOfTheCurrentFrame) {
  ProcessingTime time;
  EXPECT_EQ(time.elapsed().count(), 0);
  for (int frame = 0; frame < 2; ++frame) {
    const ProcessingTime::Frame frame_time(time);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::thread([&time] { EXPECT_GE(time.elapsed(), std::chrono::milliseconds(20)); }).join();
  }
  EXPECT_EQ(time.elapsed().count(), 0);
}

TEST(ProcessingTime, EndsWithAFrameThatFails) {
  ProcessingTime time;
  try {
    const ProcessingTime::Frame frame_time(time);
    throw std::runtime_error("no memory");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(time.elapsed().count(), 0);
}

}  // namespace
}  // namespace line_plane_segmentation
