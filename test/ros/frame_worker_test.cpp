// SPDX-License-Identifier: BSD-3-Clause
// Row 28: an exception affects its frame only.
#include "frame_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <boost/weak_ptr.hpp>
#include <chrono>
#include <future>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace line_plane_segmentation {
namespace {

InputFrame frameWithNumber(std::uint32_t number) {
  const auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.seq = number;
  return {image, boost::make_shared<sensor_msgs::CameraInfo>()};
}

// Throws another exception for each of the frames 1, 2, 3 ...
void throwAt(std::uint32_t number) {
  switch (number) {
    case 1:
      throw std::bad_alloc();
    case 2:
      throw std::runtime_error("something with a rather long explanation");
    case 3:
      throw 3;
    default:
      return;
  }
}

TEST(FrameWorker, goesOnAfterWhateverIsThrown) {
  std::vector<std::string> problems;
  std::promise<std::uint32_t> processed;
  {
    FrameWorker worker(
        10,
        [&](const InputFrame& frame) {
          throwAt(frame.image->header.seq);
          processed.set_value(frame.image->header.seq);
        },
        [&](const std::string& problem) { problems.push_back(problem); });
    for (std::uint32_t number = 1; number <= 4; ++number) worker.queue().push(frameWithNumber(number));
    auto result = processed.get_future();
    ASSERT_EQ(std::future_status::ready, result.wait_for(std::chrono::seconds(10)));
    EXPECT_EQ(4U, result.get());
  }
  EXPECT_EQ((std::vector<std::string>{"std::bad_alloc", "something with a rather long explanation",
                                      "an exception of unknown type"}),
            problems);
}

// No memory for the frame, and none to report it.
TEST(FrameWorker, goesOnWhenTellingFails) {
  std::promise<void> processed;
  FrameWorker worker(
      10,
      [&](const InputFrame& frame) {
        throwAt(frame.image->header.seq);
        processed.set_value();
      },
      [](const std::string&) { throw std::bad_alloc(); });
  worker.queue().push(frameWithNumber(1));
  worker.queue().push(frameWithNumber(4));
  EXPECT_EQ(std::future_status::ready, processed.get_future().wait_for(std::chrono::seconds(10)));
}

TEST(FrameWorker, waitsForTheFrameThatIsBeingProcessed) {
  std::promise<void> begun;
  std::atomic<bool> finished{false};
  auto worker = std::make_unique<FrameWorker>(
      10,
      [&](const InputFrame&) {
        begun.set_value();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        finished = true;
      },
      [](const std::string&) {});
  worker->queue().push(frameWithNumber(4));
  begun.get_future().wait();
  worker.reset();
  EXPECT_TRUE(finished);
}

TEST(FrameWorker, keepsNoFrame) {
  std::promise<void> processed;
  FrameWorker worker(
      10, [](const InputFrame&) { throw std::bad_alloc(); },
      [&](const std::string&) { processed.set_value(); });
  InputFrame frame = frameWithNumber(1);
  const boost::weak_ptr<const sensor_msgs::Image> image = frame.image;
  worker.queue().push(std::move(frame));
  processed.get_future().wait();
  for (int i = 0; i < 1000 && !image.expired(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(image.expired());
}

}  // namespace
}  // namespace line_plane_segmentation
