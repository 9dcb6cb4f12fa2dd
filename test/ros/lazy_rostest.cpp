// SPDX-License-Identifier: BSD-3-Clause
// No camera subscription without a subscriber of any output.
#include <gtest/gtest.h>

#include <string>

#include "any_output.h"
#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

class Lazy : public testing::Test {
 protected:
  TestCamera camera_;
};

TEST_F(Lazy, staysIdleByItself) {
  ASSERT_TRUE(waitUntil([] { return ros::service::exists("plane_segmenter/set_parameters", false); }));
  spinFor(1.0);
  EXPECT_EQ(0U, camera_.imageSubscribers());
  EXPECT_EQ(0U, camera_.infoSubscribers());
}

TEST_F(Lazy, subscribesForEachOutputAlone) {
  for (const std::string& output : outputs()) {
    {
      Anything inbox("plane_segmenter/" + output);
      EXPECT_TRUE(camera_.waitForSubscriber()) << output;
    }
    EXPECT_TRUE(camera_.waitForIdle()) << output;
  }
}

TEST_F(Lazy, subscribesOnceForAllOutputsAndUntilTheLastLeaves) {
  {
    Anything planes("plane_segmenter/planes");
    {
      Anything labels("plane_segmenter/labels");
      Anything cloud("plane_segmenter/cloud");
      ASSERT_TRUE(camera_.waitForSubscriber());
    }
    spinFor(1.0);
    EXPECT_EQ(1U, camera_.imageSubscribers());
    EXPECT_EQ(1U, camera_.infoSubscribers());
  }
  EXPECT_TRUE(camera_.waitForIdle());
}

TEST_F(Lazy, comesToRestAfterMuchComingAndGoing) {
  for (int round = 0; round < 30; ++round) {
    Anything planes("plane_segmenter/planes");
    spinFor(0.005 * (round % 4));
  }
  EXPECT_TRUE(camera_.waitForIdle());
  Anything planes("plane_segmenter/planes");
  EXPECT_TRUE(camera_.waitForSubscriber());
}

}  // namespace
}  // namespace line_plane_segmentation
