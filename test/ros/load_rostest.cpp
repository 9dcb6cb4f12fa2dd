// SPDX-License-Identifier: BSD-3-Clause
// An increasing number of VGA cameras in one manager, each with its own segmenter, at 30 Hz: every frame is
// answered, in order. scripts/load uses the default queue sizes, with which frames may be dropped. ~cameras
// lists the numbers of cameras, each of which runs for ~seconds. Times are printed, not tested.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <ros/callback_queue.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "nodelet_calls.h"
#include "simulated_frames.h"
#include "test_camera.h"
#include "test_process.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

constexpr double kRate = 30.0;  // [Hz]
constexpr int kLongQueue = 100;

/// A camera in its own room, its segmenter, and a subscriber of its planes.
class Side {
 public:
  explicit Side(int number)
      : name_("/camera_" + std::to_string(number)),
        camera_(name_, kLongQueue),
        diagnostics_((name_ + "/plane_segmenter").substr(1)),
        frames_(simulatedFrames(static_cast<std::uint64_t>(number), 10, 640, 480)),
        planes_(ros::NodeHandle().subscribe<PlaneArray>(
            name_ + "/plane_segmenter/planes", 1000,
            [this](const PlaneArray::ConstPtr& planes) { take(*planes); })) {}
  Side(const Side&) = delete;
  Side& operator=(const Side&) = delete;
  ~Side() { unloadSegmenter(name_ + "/plane_segmenter"); }

  bool start(int queue_size, int scanline_spacing) const {
    ros::param::set(name_ + "/plane_segmenter/queue_size", queue_size);
    ros::param::set(name_ + "/plane_segmenter/scanline_spacing", scanline_spacing);
    return loadSegmenter(name_ + "/plane_segmenter") && camera_.waitForSubscriber();
  }

  // The timestamp is the time of sending.
  void publish() {
    const TestFrame& frame = frames_[static_cast<std::size_t>(sent_) % frames_.size()];
    camera_.publish(frame.image, frame.info, ros::Time(now()));
    ++sent_;
  }

  /// Waits until all sent frames are answered or dropped, and the diagnostics report it.
  void settle() {
    waitUntil([&] { return sent_ == static_cast<int>(delays_.size()); }, 0.5);
    EXPECT_TRUE(diagnostics_.waitForReport());
  }

  void forget() {
    dropped_before_ = droppedSinceTheStart();
    sent_ = 0;
    delays_.clear();
  }

  int sent() const { return sent_; }
  int dropped() const { return droppedSinceTheStart() - dropped_before_; }
  const std::vector<double>& delays() const { return delays_; }

 private:
  int droppedSinceTheStart() const { return static_cast<int>(diagnostics_.number("frames dropped")); }

  void take(const PlaneArray& planes) {
    EXPECT_GT(planes.header.stamp, newest_) << name_ << " answers an older frame after a newer one";
    newest_ = planes.header.stamp;
    delays_.push_back(now() - newest_.toSec());
  }

  std::string name_;
  TestCamera camera_;
  Diagnostics diagnostics_;
  std::vector<TestFrame> frames_;
  int sent_ = 0, dropped_before_ = 0;
  ros::Time newest_;
  std::vector<double> delays_;  // [s] of the answers
  ros::Subscriber planes_;
};

class Load : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("/manager/load_nodelet", 15000));
    manager_ = processOfNode("/manager");
    ASSERT_GT(manager_, 0);
  }

  void addCameras(int count) {
    while (static_cast<int>(sides_.size()) < count) {
      sides_.push_back(std::make_unique<Side>(static_cast<int>(sides_.size()) + 1));
      ASSERT_TRUE(sides_.back()->start(queue_size_, scanline_spacing_));
    }
  }

  // The cameras send in turn, which unsynchronised cameras do on average.
  void publishFor(double seconds) {
    const double start = now();
    const double pause = 1.0 / kRate / static_cast<double>(sides_.size());
    const int count = static_cast<int>(seconds / pause);
    for (int i = 0; i < count && ros::ok(); ++i) {
      sides_[static_cast<std::size_t>(i) % sides_.size()]->publish();
      for (double left = 0.0; left >= 0.0; left = start + (i + 1) * pause - now()) {
        ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(left));
      }
    }
  }

  void measure(double seconds) {
    publishFor(1.0);
    for (const auto& side : sides_) side->settle();
    for (const auto& side : sides_) side->forget();
    const double used_before = processorSeconds(manager_);
    const double start = now();
    publishFor(seconds);
    const double used = (processorSeconds(manager_) - used_before) / (now() - start);
    EXPECT_GT(used, 0.0);
    for (const auto& side : sides_) side->settle();
    report(used);
  }

  void report(double used) const {
    int sent = 0, answered = 0, dropped = 0;
    std::vector<double> delays;
    for (const auto& side : sides_) {
      EXPECT_GT(side->delays().size(), 0U);
      sent += side->sent();
      answered += static_cast<int>(side->delays().size());
      dropped += side->dropped();
      delays.insert(delays.end(), side->delays().begin(), side->delays().end());
    }
    const int lost = sent - answered - dropped;
    EXPECT_GE(lost, 0);
    if (queue_size_ == kLongQueue) {
      EXPECT_EQ(sent, answered);
    }
    std::sort(delays.begin(), delays.end());
    ASSERT_FALSE(delays.empty());
    double machine_load = 0.0;
    EXPECT_EQ(1, getloadavg(&machine_load, 1));
    std::printf("| %zu | %d | %d | %d | %d | %.1f | %.1f | %.0f %% | %.1f |\n", sides_.size(), sent, answered,
                dropped, lost, 1e3 * delays[delays.size() / 2], 1e3 * delays.back(), 100.0 * used,
                machine_load);
    std::fflush(stdout);
  }

  const int queue_size_ = ros::param::param("~queue_size", kLongQueue);
  const int scanline_spacing_ = ros::param::param("~scanline_spacing", 0);
  int manager_ = -1;
  std::vector<std::unique_ptr<Side>> sides_;
};

TEST_F(Load, everyFrameIsAnswered) {
  std::vector<int> counts = {2};
  ros::param::get("~cameras", counts);
  const double seconds = ros::param::param("~seconds", 3.0);
  std::printf(
      "| cameras | sent | answered | dropped, counted | lost in sockets | median delay [ms] | worst [ms] | "
      "processor time | load average |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const int count : counts) {
    ASSERT_NO_FATAL_FAILURE(addCameras(count));
    measure(seconds);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
