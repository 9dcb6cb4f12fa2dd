// SPDX-License-Identifier: BSD-3-Clause
#include "frame_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <chrono>
#include <thread>

namespace line_plane_segmentation {
namespace {

InputFrame frameWithNumber(std::uint32_t number) {
  const auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.seq = number;
  return {image, boost::make_shared<sensor_msgs::CameraInfo>()};
}

std::uint32_t popNumber(FrameQueue& queue) {
  InputFrame frame;
  return queue.pop(frame) ? frame.image->header.seq : 0;
}

TEST(FrameQueue, keepsOrderAndAllWhileTheyFit) {
  FrameQueue queue(3);
  for (std::uint32_t number : {1U, 2U, 3U}) queue.push(frameWithNumber(number));
  for (std::uint32_t number : {1U, 2U, 3U}) EXPECT_EQ(number, popNumber(queue));
  EXPECT_EQ(0U, queue.dropped());
}

TEST(FrameQueue, newestFirstOnceItOverflows) {
  FrameQueue queue(3);
  for (std::uint32_t number : {1U, 2U, 3U, 4U}) queue.push(frameWithNumber(number));
  EXPECT_EQ(3U, queue.dropped());
  EXPECT_EQ(4U, popNumber(queue));
}

// Two frames arrive while one is processed: the number of waiting frames must not grow to the queue's
// capacity again.
TEST(FrameQueue, newestFirstAsLongAsProcessingIsBehind) {
  FrameQueue queue(3);
  for (std::uint32_t number : {1U, 2U, 3U, 4U}) queue.push(frameWithNumber(number));
  std::uint32_t number = 4;
  for (int round = 0; round < 10; ++round) {
    EXPECT_EQ(number, popNumber(queue));
    queue.push(frameWithNumber(++number));
    queue.push(frameWithNumber(++number));
  }
  EXPECT_EQ(13U, queue.dropped());
}

TEST(FrameQueue, keepsAllAgainOnceProcessingHasCaughtUp) {
  FrameQueue queue(3);
  for (std::uint32_t number : {1U, 2U, 3U, 4U}) queue.push(frameWithNumber(number));
  EXPECT_EQ(4U, popNumber(queue));

  std::atomic<bool> about_to_wait{false};
  std::thread processing([&] {
    about_to_wait = true;
    EXPECT_EQ(5U, popNumber(queue));
  });
  while (!about_to_wait) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  queue.push(frameWithNumber(5));
  processing.join();

  for (std::uint32_t number : {6U, 7U, 8U}) queue.push(frameWithNumber(number));
  for (std::uint32_t number : {6U, 7U, 8U}) EXPECT_EQ(number, popNumber(queue));
  EXPECT_EQ(3U, queue.dropped());
}

TEST(FrameQueue, forgetsWithoutCounting) {
  FrameQueue queue(3);
  queue.push(frameWithNumber(1));
  queue.clear();
  queue.push(frameWithNumber(2));
  EXPECT_EQ(2U, popNumber(queue));
  EXPECT_EQ(0U, queue.dropped());
}

TEST(FrameQueue, closingWakesWhoeverWaits) {
  FrameQueue queue(3);
  bool popped = true;
  std::thread waiting([&] {
    InputFrame frame;
    popped = queue.pop(frame);
  });
  queue.close();
  waiting.join();
  EXPECT_FALSE(popped);
  queue.push(frameWithNumber(1));
  InputFrame frame;
  EXPECT_FALSE(queue.pop(frame));
}

}  // namespace
}  // namespace line_plane_segmentation
