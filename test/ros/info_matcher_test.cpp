// SPDX-License-Identifier: BSD-3-Clause
#include "info_matcher.h"

#include <gtest/gtest.h>

#include "stamped_messages.h"

namespace line_plane_segmentation {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// A matcher with its history, and a clock that is advanced by hand.
class Camera {
 public:
  explicit Camera(InfoMatching matching, std::size_t waiting = 5,
                  InfoMatcher::FallbackRule rule = InfoMatcher::FallbackRule::kAfterSecond)
      : matcher(matching, waiting, rule) {}

  // Both return the frames that become whole.
  InfoMatcher::Frames image(const DepthMessage& message) {
    InfoMatcher::Frames frames;
    matcher.addImage(message, infos, now, frames);
    return frames;
  }
  InfoMatcher::Frames info(const sensor_msgs::CameraInfoConstPtr& message) {
    InfoMatcher::Frames frames;
    infos.add(message, now);
    matcher.addInfo(message->header.stamp, infos, frames);
    return frames;
  }
  InfoMatcher::Frames poll() {
    InfoMatcher::Frames frames;
    matcher.poll(infos, now, frames);
    return frames;
  }
  InfoMatcher::Frames finish() {
    InfoMatcher::Frames frames;
    matcher.finish(infos, frames);
    return frames;
  }

  InfoHistory::TimePoint now = InfoHistory::TimePoint{} + std::chrono::hours(1);
  InfoHistory infos{seconds(10), 1000};
  InfoMatcher matcher;
};

TEST(InfoMatcher, pairsWhicheverComesFirst) {
  Camera camera(InfoMatching::kExact);
  const auto image = imageAt(1.0);
  const auto info = infoAt(1.0);
  EXPECT_TRUE(camera.image(image).empty());
  const InfoMatcher::Frames frames = camera.info(info);
  ASSERT_EQ(1U, frames.size());
  EXPECT_EQ(image.image, frames[0].image);
  EXPECT_EQ(info, frames[0].info);

  EXPECT_TRUE(camera.info(infoAt(2.0)).empty());
  const InfoMatcher::Frames second = camera.image(imageAt(2.0));
  ASSERT_EQ(1U, second.size());
  EXPECT_EQ(ros::Time(2.0), second[0].image->header.stamp);
}

TEST(InfoMatcher, wantsExactlyTheSameStamp) {
  Camera camera(InfoMatching::kExact);
  EXPECT_TRUE(camera.image(imageAt(1.0)).empty());
  EXPECT_TRUE(camera.info(infoAt(1.000000001)).empty());
  camera.now += seconds(100);
  EXPECT_TRUE(camera.image(imageAt(2.0)).empty());
  EXPECT_TRUE(camera.poll().empty());
  EXPECT_TRUE(camera.finish().empty());
  EXPECT_EQ(2U, camera.matcher.lostImages());
}

TEST(InfoMatcher, givesEachImageOnce) {
  Camera camera(InfoMatching::kExact);
  camera.image(imageAt(1.0));
  EXPECT_EQ(1U, camera.info(infoAt(1.0)).size());
  EXPECT_TRUE(camera.info(infoAt(1.0)).empty());
}

TEST(InfoMatcher, keepsTheOrderOfEqualStamps) {
  Camera camera(InfoMatching::kExact);
  const auto first = imageAt(0.0);
  const auto second = imageAt(0.0);
  camera.image(first);
  camera.image(second);
  const InfoMatcher::Frames frames = camera.info(infoAt(0.0));
  ASSERT_EQ(2U, frames.size());
  EXPECT_EQ(first.image, frames[0].image);
  EXPECT_EQ(second.image, frames[1].image);
}

TEST(InfoMatcher, countsTheImagesThatItLetsGo) {
  Camera camera(InfoMatching::kExact, 2);
  for (const double stamp : {1.0, 2.0, 3.0}) camera.image(imageAt(stamp));
  EXPECT_EQ(1U, camera.matcher.lostImages());
  EXPECT_EQ(0U, camera.matcher.lateInfos());
  EXPECT_TRUE(camera.info(infoAt(1.0)).empty());
  EXPECT_EQ(1U, camera.matcher.lateInfos()) << "it came too late";
  EXPECT_EQ(1U, camera.info(infoAt(2.0)).size());
  EXPECT_EQ(1U, camera.info(infoAt(3.0)).size());
  EXPECT_EQ(1U, camera.matcher.lostImages());
}

// A bag that starts again: messages that wait with later stamps must not keep the earlier ones out.
TEST(InfoMatcher, goesOnWhenStampsGoBack) {
  Camera camera(InfoMatching::kExact, 3);
  for (const double stamp : {101.0, 102.0, 103.0}) camera.image(imageAt(stamp));
  for (const double stamp : {1.0, 2.0, 3.0, 4.0}) {
    EXPECT_TRUE(camera.image(imageAt(stamp)).empty());
    EXPECT_EQ(1U, camera.info(infoAt(stamp)).size()) << stamp;
  }
}

TEST(InfoMatcher, forgets) {
  Camera camera(InfoMatching::kExact);
  camera.image(imageAt(1.0));
  camera.matcher.clear();
  EXPECT_TRUE(camera.info(infoAt(1.0)).empty());
  EXPECT_EQ(0U, camera.matcher.lostImages());
}

// As over a slow link: nine seconds of camera_info at 30 Hz are ahead of the image.
TEST(InfoMatcher, imagesMayLagFarBehind) {
  Camera camera(InfoMatching::kExact);
  for (int i = 0; i < 270; ++i) {
    camera.info(infoAt(i / 30.0));
    camera.now += milliseconds(33);
  }
  EXPECT_EQ(1U, camera.image(imageAt(0.0)).size());
  EXPECT_EQ(1U, camera.image(imageAt(100 / 30.0)).size());
  camera.now += seconds(11);
  camera.info(infoAt(20.0));
  EXPECT_TRUE(camera.image(imageAt(200 / 30.0)).empty()) << "kept for longer than promised";
}

TEST(InfoMatcher, latestNeedsNoStamp) {
  Camera camera(InfoMatching::kLatest);
  EXPECT_TRUE(camera.image(imageAt(1.0)).empty());
  EXPECT_EQ(1U, camera.info(infoAt(0.0, "another")).size());
  const auto newest = infoAt(0.5, "a third");
  camera.info(newest);
  const InfoMatcher::Frames frames = camera.image(imageAt(7.0));
  ASSERT_EQ(1U, frames.size());
  EXPECT_EQ(newest, frames[0].info);
  EXPECT_FALSE(camera.matcher.hasFallenBack()) << "this is as asked for";
}

TEST(InfoMatcher, fallsBackAfterASecondWithoutAPair) {
  Camera camera(InfoMatching::kAuto, 40);
  camera.info(infoAt(0.0));
  std::size_t frames = 0;
  for (int i = 1; i <= 60; ++i) {
    frames += camera.image(imageAt(100.0 + i)).size();
    EXPECT_EQ(i > 30, camera.matcher.hasFallenBack()) << i;
    camera.now += milliseconds(34);
  }
  EXPECT_EQ(60U, frames) << "those that waited meanwhile come, too";
  EXPECT_EQ(0U, camera.matcher.lostImages());
}

TEST(InfoMatcher, aSingleImageIsNotForgotten) {
  Camera camera(InfoMatching::kAuto);
  camera.info(infoAt(0.0));
  EXPECT_TRUE(camera.image(imageAt(5.0)).empty());
  EXPECT_TRUE(camera.poll().empty());
  camera.now += seconds(1);
  EXPECT_EQ(1U, camera.poll().size());
}

TEST(InfoMatcher, goesBackToExactWhenThatWorks) {
  for (const bool info_comes_first : {true, false}) {
    Camera camera(InfoMatching::kAuto);
    camera.info(infoAt(0.0));
    camera.image(imageAt(1.0));
    camera.now += seconds(2);
    EXPECT_EQ(2U, camera.image(imageAt(2.0)).size());
    ASSERT_TRUE(camera.matcher.hasFallenBack());
    if (info_comes_first) {
      camera.info(infoAt(3.0));
      EXPECT_EQ(1U, camera.image(imageAt(3.0)).size());
    } else {
      EXPECT_EQ(1U, camera.image(imageAt(3.0)).size());
      EXPECT_TRUE(camera.info(infoAt(3.0)).empty()) << "the image came twice";
    }
    EXPECT_FALSE(camera.matcher.hasFallenBack());
    EXPECT_TRUE(camera.image(imageAt(4.0)).empty()) << "its own camera_info is waited for again";
    EXPECT_EQ(1U, camera.info(infoAt(4.0)).size());
  }
}

TEST(InfoMatcher, fallsBackOnlyToTheSameFrameAndSize) {
  Camera camera(InfoMatching::kAuto);
  camera.info(infoAt(0.0, "another_camera"));
  const auto other_size = infoAt(0.1);
  other_size->width = 2 * kWidth;
  camera.info(other_size);
  camera.image(imageAt(1.0));
  camera.now += seconds(2);
  EXPECT_TRUE(camera.image(imageAt(2.0)).empty());
  EXPECT_FALSE(camera.matcher.hasFallenBack());
  // The slash does not count, nor does a frame that is not given.
  EXPECT_EQ(2U, camera.info(infoAt(0.2, "/camera")).size() + camera.image(imageAt(3.0)).size() - 1U);
  EXPECT_EQ(1U, camera.image(imageAt(4.0, "")).size());
}

// A camera that is slower than a second, with its camera_info just behind the image.
TEST(InfoMatcher, aSlowCameraIsNoReasonToFallBack) {
  Camera camera(InfoMatching::kAuto);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(camera.image(imageAt(2.0 * i)).empty());
    camera.now += milliseconds(5);
    EXPECT_EQ(1U, camera.info(infoAt(2.0 * i)).size());
    EXPECT_FALSE(camera.matcher.hasFallenBack());
    camera.now += seconds(2);
  }
}

// With FallbackRule::kWhenFull, for bags, time does not count.
TEST(InfoMatcher, fallsBackWhenAsManyWaitAsMayOrAtTheEnd) {
  Camera camera(InfoMatching::kAuto, 4, InfoMatcher::FallbackRule::kWhenFull);
  camera.info(infoAt(1.0));
  EXPECT_EQ(1U, camera.image(imageAt(1.0)).size());
  for (const double stamp : {2.0, 3.0, 4.0}) EXPECT_TRUE(camera.image(imageAt(stamp)).empty());
  EXPECT_EQ(4U, camera.image(imageAt(5.0)).size());
  EXPECT_EQ(1U, camera.image(imageAt(6.0)).size());
  camera.info(infoAt(7.0));
  EXPECT_EQ(1U, camera.image(imageAt(7.0)).size());
  EXPECT_TRUE(camera.image(imageAt(8.0)).empty());
  EXPECT_EQ(1U, camera.finish().size());
  EXPECT_EQ(0U, camera.matcher.lostImages());
}

// One missing camera_info among others is a lost image, and no frame out of order.
TEST(InfoMatcher, givesNoFrameOutOfOrder) {
  Camera camera(InfoMatching::kAuto, 4, InfoMatcher::FallbackRule::kWhenFull);
  camera.image(imageAt(1.0));
  camera.image(imageAt(2.0));
  EXPECT_EQ(1U, camera.info(infoAt(2.0)).size());
  EXPECT_TRUE(camera.finish().empty());
  EXPECT_EQ(1U, camera.matcher.lostImages());
}

TEST(InfoMatching, hasNames) {
  for (const auto matching : {InfoMatching::kExact, InfoMatching::kLatest, InfoMatching::kAuto}) {
    EXPECT_EQ(matching, infoMatchingOf(nameOf(matching)));
  }
  EXPECT_FALSE(infoMatchingOf("nearest"));
}

}  // namespace
}  // namespace line_plane_segmentation
