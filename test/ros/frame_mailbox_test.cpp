// SPDX-License-Identifier: BSD-3-Clause
// Rows 28 and 33: an exception affects its frame only; the newest frame wins when processing is behind.
#include "frame_mailbox.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <boost/weak_ptr.hpp>
#include <chrono>
#include <condition_variable>
#include <future>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace line_plane_segmentation {
namespace {

InputFrame frameWithNumber(std::uint32_t number) {
  const auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.seq = number;
  return {image, boost::make_shared<sensor_msgs::CameraInfo>()};
}

/// A mailbox whose frames are processed until finish() is called.
class FrameMailboxUnderControl : public testing::Test {
 protected:
  ~FrameMailboxUnderControl() override {
    finishAll();
    mailbox_.reset();
  }

  FrameMailbox& mailbox() { return *mailbox_; }

  void push(std::uint32_t number) { mailbox_->push(frameWithNumber(number)); }
  void pushAll(std::initializer_list<std::uint32_t> numbers) {
    for (const std::uint32_t number : numbers) push(number);
  }

  /// Pushes a frame and expects it to be processed, until finish() is called.
  void hold(std::uint32_t number) {
    push(number);
    EXPECT_EQ(number, current());
  }

  void expectProcessed(std::initializer_list<std::uint32_t> numbers) {
    for (const std::uint32_t number : numbers) EXPECT_EQ(number, processNext());
  }

  /// Waits for a frame to be processed, and returns its number; 0 if none is within 10 s.
  std::uint32_t current() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(10), [this] { return current_ != 0; });
    return current_;
  }

  /// Ends the processing of the current frame.
  void finish() {
    const std::lock_guard<std::mutex> lock(mutex_);
    current_ = 0;
    changed_.notify_all();
  }

  /// Waits for the next frame, ends its processing, and returns its number.
  std::uint32_t processNext() {
    const std::uint32_t number = current();
    finish();
    return number;
  }

  /// Makes the thread end each frame at once.
  void finishAll() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_held_ = false;
    }
    finish();
  }

 private:
  static constexpr std::size_t kCapacity = 3;

  void process(std::uint32_t number) {
    std::unique_lock<std::mutex> lock(mutex_);
    current_ = number;
    changed_.notify_all();
    changed_.wait(lock, [this] { return current_ == 0 || !is_held_; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint32_t current_ = 0;
  bool is_held_ = true;
  std::unique_ptr<FrameMailbox> mailbox_ = std::make_unique<FrameMailbox>(
      kCapacity, [this](const InputFrame& frame) { process(frame.image->header.seq); },
      [](const std::string&) {});
};

TEST_F(FrameMailboxUnderControl, keepsOrderAndAllWhileTheyFit) {
  hold(100);
  pushAll({1, 2, 3});
  finish();
  expectProcessed({1, 2, 3});
  EXPECT_EQ(0U, mailbox().dropped());
}

TEST_F(FrameMailboxUnderControl, newestFirstOnceItOverflows) {
  hold(100);
  pushAll({1, 2, 3, 4});
  EXPECT_EQ(3U, mailbox().dropped());
  finish();
  EXPECT_EQ(4U, current());
}

// Two frames arrive while one is processed: the number of waiting frames must not grow to the capacity again.
TEST_F(FrameMailboxUnderControl, newestFirstAsLongAsProcessingIsBehind) {
  hold(100);
  pushAll({1, 2, 3, 4});
  finish();
  std::uint32_t number = 4;
  for (int round = 0; round < 10; ++round) {
    EXPECT_EQ(number, current());
    push(++number);
    push(++number);
    finish();
  }
  EXPECT_EQ(number, current());
  EXPECT_EQ(13U, mailbox().dropped());
}

TEST_F(FrameMailboxUnderControl, keepsAllAgainOnceProcessingHasCaughtUp) {
  hold(100);
  pushAll({1, 2, 3, 4});
  finish();
  EXPECT_EQ(4U, processNext());
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // the thread waits for frames now

  hold(5);
  pushAll({6, 7, 8});
  finish();
  expectProcessed({6, 7, 8});
  EXPECT_EQ(3U, mailbox().dropped());
}

TEST_F(FrameMailboxUnderControl, forgetsWithoutCounting) {
  hold(100);
  push(1);
  mailbox().clear();
  push(2);
  finish();
  EXPECT_EQ(2U, current());
  EXPECT_EQ(0U, mailbox().dropped());
}

TEST_F(FrameMailboxUnderControl, isNearlyFullBeforeTheNextTwoFramesOverflowIt) {
  hold(100);
  push(1);
  EXPECT_FALSE(mailbox().nearlyFull());
  push(2);
  EXPECT_TRUE(mailbox().nearlyFull());
  EXPECT_EQ(0U, mailbox().dropped());
}

TEST(FrameMailbox, endsWhileItWaits) {
  FrameMailbox mailbox(
      3, [](const InputFrame&) {}, [](const std::string&) {});
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
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

TEST(FrameMailbox, goesOnAfterWhateverIsThrown) {
  std::vector<std::string> problems;
  std::promise<std::uint32_t> processed;
  {
    FrameMailbox mailbox(
        10,
        [&](const InputFrame& frame) {
          throwAt(frame.image->header.seq);
          processed.set_value(frame.image->header.seq);
        },
        [&](const std::string& problem) { problems.push_back(problem); });
    for (std::uint32_t number = 1; number <= 4; ++number) mailbox.push(frameWithNumber(number));
    auto result = processed.get_future();
    ASSERT_EQ(std::future_status::ready, result.wait_for(std::chrono::seconds(10)));
    EXPECT_EQ(4U, result.get());
  }
  EXPECT_EQ((std::vector<std::string>{"std::bad_alloc", "something with a rather long explanation",
                                      "an exception of unknown type"}),
            problems);
}

// No memory for the frame, and none to report it.
TEST(FrameMailbox, goesOnWhenTellingFails) {
  std::promise<void> processed;
  FrameMailbox mailbox(
      10,
      [&](const InputFrame& frame) {
        throwAt(frame.image->header.seq);
        processed.set_value();
      },
      [](const std::string&) { throw std::bad_alloc(); });
  mailbox.push(frameWithNumber(1));
  mailbox.push(frameWithNumber(4));
  EXPECT_EQ(std::future_status::ready, processed.get_future().wait_for(std::chrono::seconds(10)));
}

// The current frame learns that it shall end; frames behind it are not processed.
TEST(FrameMailbox, waitsForTheFrameThatIsBeingProcessed) {
  std::promise<void> begun;
  std::atomic<const FrameMailbox*> stopping{nullptr};
  std::atomic<int> finished{0};
  auto mailbox = std::make_unique<FrameMailbox>(
      10,
      [&](const InputFrame&) {
        begun.set_value();
        while (stopping == nullptr || !stopping.load()->isStopping()) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        ++finished;
      },
      [](const std::string&) {});
  stopping = mailbox.get();
  mailbox->push(frameWithNumber(4));
  begun.get_future().wait();
  EXPECT_FALSE(mailbox->isStopping());
  mailbox->push(frameWithNumber(5));
  mailbox.reset();
  EXPECT_EQ(1, finished);
}

TEST(FrameMailbox, keepsNoFrame) {
  std::promise<void> processed;
  FrameMailbox mailbox(
      10, [](const InputFrame&) { throw std::bad_alloc(); },
      [&](const std::string&) { processed.set_value(); });
  InputFrame frame = frameWithNumber(1);
  const boost::weak_ptr<const sensor_msgs::Image> image = frame.image;
  mailbox.push(std::move(frame));
  processed.get_future().wait();
  for (int i = 0; i < 1000 && !image.expired(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(image.expired());
}

}  // namespace
}  // namespace line_plane_segmentation
