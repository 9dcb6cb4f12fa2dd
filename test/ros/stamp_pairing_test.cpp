// SPDX-License-Identifier: BSD-3-Clause
#include "stamp_pairing.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

namespace line_plane_segmentation {
namespace {

sensor_msgs::ImageConstPtr imageAt(double stamp) {
  const auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.stamp = ros::Time(stamp);
  return image;
}

sensor_msgs::CameraInfoConstPtr infoAt(double stamp) {
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
  info->header.stamp = ros::Time(stamp);
  return info;
}

TEST(StampPairing, pairsWhicheverComesFirst) {
  StampPairing pairing(5);
  CameraFrame frame;
  const auto image = imageAt(1.0);
  const auto info = infoAt(1.0);
  EXPECT_FALSE(pairing.add(image, frame));
  EXPECT_TRUE(pairing.add(info, frame));
  EXPECT_EQ(image, frame.image);
  EXPECT_EQ(info, frame.info);

  EXPECT_FALSE(pairing.add(infoAt(2.0), frame));
  EXPECT_TRUE(pairing.add(imageAt(2.0), frame));
  EXPECT_EQ(ros::Time(2.0), frame.image->header.stamp);
  EXPECT_EQ(ros::Time(2.0), frame.info->header.stamp);
}

TEST(StampPairing, wantsExactlyTheSameStamp) {
  StampPairing pairing(5);
  CameraFrame frame;
  EXPECT_FALSE(pairing.add(imageAt(1.0), frame));
  EXPECT_FALSE(pairing.add(infoAt(1.000000001), frame));
  EXPECT_FALSE(frame.image);
}

TEST(StampPairing, usesAMessageOnce) {
  StampPairing pairing(5);
  CameraFrame frame;
  pairing.add(imageAt(1.0), frame);
  EXPECT_TRUE(pairing.add(infoAt(1.0), frame));
  EXPECT_FALSE(pairing.add(infoAt(1.0), frame));
}

TEST(StampPairing, pairsDuplicateStampsInTheirOrder) {
  StampPairing pairing(5);
  CameraFrame frame;
  const auto first = imageAt(0.0);
  const auto second = imageAt(0.0);
  pairing.add(first, frame);
  pairing.add(second, frame);
  EXPECT_TRUE(pairing.add(infoAt(0.0), frame));
  EXPECT_EQ(first, frame.image);
  EXPECT_TRUE(pairing.add(infoAt(0.0), frame));
  EXPECT_EQ(second, frame.image);
}

TEST(StampPairing, letsTheLongestWaitingGo) {
  StampPairing pairing(2);
  CameraFrame frame;
  for (const double stamp : {1.0, 2.0, 3.0}) pairing.add(imageAt(stamp), frame);
  EXPECT_FALSE(pairing.add(infoAt(1.0), frame));
  EXPECT_TRUE(pairing.add(infoAt(2.0), frame));
  EXPECT_TRUE(pairing.add(infoAt(3.0), frame));
}

// A slow network: the images arrive long after their camera_info.
TEST(StampPairing, keepsCameraInfosForLateImages) {
  StampPairing pairing(2);
  CameraFrame frame;
  constexpr int kLag = StampPairing::kMaxInfos - 1;
  for (int i = 0; i < 3 * kLag; ++i) {
    pairing.add(infoAt(1.0 + i), frame);
    if (i >= kLag) EXPECT_TRUE(pairing.add(imageAt(1.0 + i - kLag), frame)) << i;
  }
  EXPECT_EQ(0U, pairing.lostImages());
}

TEST(StampPairing, countsLostImages) {
  StampPairing pairing(2);
  CameraFrame frame;
  for (const double stamp : {1.0, 2.0, 3.0, 4.0}) pairing.add(imageAt(stamp), frame);
  EXPECT_EQ(2U, pairing.lostImages());
  EXPECT_EQ(0U, pairing.lateInfos());
  EXPECT_FALSE(pairing.add(infoAt(2.0), frame));
  EXPECT_EQ(1U, pairing.lateInfos());
  EXPECT_TRUE(pairing.add(imageAt(2.0), frame)) << "it comes again in a bag's second loop";
  pairing.clear();
  EXPECT_EQ(2U, pairing.lostImages()) << "what is cleared is not lost";
}

// A bag that starts again: messages that wait with later stamps must not keep the earlier ones out.
TEST(StampPairing, goesOnWhenStampsGoBack) {
  StampPairing pairing(3);
  CameraFrame frame;
  for (const double stamp : {101.0, 102.0, 103.0}) pairing.add(imageAt(stamp), frame);
  for (const double stamp : {1.0, 2.0, 3.0, 4.0}) {
    EXPECT_FALSE(pairing.add(imageAt(stamp), frame));
    EXPECT_TRUE(pairing.add(infoAt(stamp), frame)) << stamp;
  }
}

TEST(StampPairing, forgets) {
  StampPairing pairing(3);
  CameraFrame frame;
  pairing.add(imageAt(1.0), frame);
  pairing.clear();
  EXPECT_FALSE(pairing.add(infoAt(1.0), frame));
}

}  // namespace
}  // namespace line_plane_segmentation
