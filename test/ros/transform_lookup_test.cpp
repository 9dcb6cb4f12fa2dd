// SPDX-License-Identifier: BSD-3-Clause
#include "transform_lookup.h"

#include <gtest/gtest.h>
#include <tf2_eigen/tf2_eigen.h>

#include <limits>
#include <string>
#include <utility>

namespace line_plane_segmentation {
namespace {

using Status = TransformLookup::Status;

class Lookup : public testing::Test {
 protected:
  // The camera at this position on the world's x axis, rotated by 180 degrees about z.
  void put(double seconds, double x, bool is_static = false) {
    geometry_msgs::TransformStamped message;
    message.header.stamp = ros::Time(seconds);
    message.header.frame_id = "world";
    message.child_frame_id = "camera";
    message.transform.translation.x = x;
    message.transform.rotation.z = 1.002;  // as sloppy as tf lets pass
    ASSERT_TRUE(buffer_.setTransform(message, "test", is_static));
  }

  Status statusAt(double seconds, const std::string& target = "world", const std::string& source = "camera") {
    lookup_ = lookUp(buffer_, target, source, ros::Time(seconds));
    EXPECT_EQ(lookup_.found(), lookup_.problem.empty()) << lookup_.problem;
    return lookup_.status;
  }

  tf2::BufferCore buffer_;
  TransformLookup lookup_;
};

TEST_F(Lookup, interpolatesAndIsARotation) {
  put(100.0, 1.0);
  put(101.0, 2.0);
  ASSERT_EQ(Status::kFound, statusAt(100.25));
  EXPECT_NEAR(1.25, lookup_.transform.translation().x(), 1e-6);
  EXPECT_NEAR(-1.0, lookup_.transform.linear()(0, 0), 1e-12);
  EXPECT_NEAR(1.0, lookup_.transform.linear().determinant(), 1e-12);
}

TEST_F(Lookup, tellsLateFromUnknownFromMissing) {
  EXPECT_EQ(Status::kUnknown, statusAt(100.0)) << "nothing is known of these frames";
  put(100.0, 1.0);
  put(101.0, 2.0);
  EXPECT_EQ(Status::kLate, statusAt(101.001));
  EXPECT_EQ(Status::kMissing, statusAt(99.0)) << "what is over does not come";
  EXPECT_EQ(Status::kUnknown, statusAt(101.5, "map")) << "nobody knows this frame";
  EXPECT_NE(std::string::npos, lookup_.problem.find("map"));
}

TEST_F(Lookup, standsAnyName) {
  put(100.0, 1.0);
  const std::pair<const char*, Status> cases[] = {{"", Status::kMissing},
                                                  {"/world", Status::kMissing},
                                                  {" ", Status::kUnknown},
                                                  {"no such frame", Status::kUnknown}};
  for (const auto& [name, status] : cases) {
    EXPECT_EQ(status, statusAt(100.0, name)) << name;
    EXPECT_EQ(status, statusAt(100.0, "world", name)) << name;
  }
}

// tf2 computes differences of times, which overflow.
TEST_F(Lookup, standsAnyTime) {
  put(100.0, 1.0);
  put(101.0, 2.0);
  for (const double seconds : {1e-9, 2147483648.0, 4294967295.0})
    EXPECT_NE(Status::kFound, statusAt(seconds)) << seconds;
}

TEST_F(Lookup, isItselfInItself) {
  EXPECT_EQ(Status::kFound, statusAt(100.0, "camera", "camera"));
  EXPECT_TRUE(lookup_.transform.isApprox(Eigen::Isometry3d::Identity()));
}

TEST_F(Lookup, holdsAtAllTimesIfStatic) {
  put(100.0, 3.0, true);
  for (const double seconds : {0.0, 1.0, 100.0, 4294967295.0}) {
    EXPECT_EQ(Status::kFound, statusAt(seconds)) << seconds;
    EXPECT_EQ(3.0, lookup_.transform.translation().x());
  }
}

TEST_F(Lookup, takesTheNewestForTimeZero) {
  put(100.0, 1.0);
  put(101.0, 2.0);
  ASSERT_EQ(Status::kFound, statusAt(0.0));
  EXPECT_NEAR(2.0, lookup_.transform.translation().x(), 1e-9);
}

// Row 21: without simulated time tf is not notified that a bag loops.
TEST_F(Lookup, tellsWhatIsTooOldForTf) {
  for (int i = 0; i <= 20; ++i) put(1000.0 + i, 1.0);
  EXPECT_EQ(Status::kUnknown, statusAt(500.0)) << "from now on those of the new time may come";
  EXPECT_EQ(Status::kFound, statusAt(1015.0)) << "one old image has emptied the buffer";
}

TEST_F(Lookup, tellsByHowMuchItWasMissed) {
  put(100.0, 1.0);
  put(101.0, 2.0);
  ASSERT_EQ(Status::kLate, statusAt(101.25));
  EXPECT_NEAR(0.25, lookup_.missed_by, 1e-6);
  const std::string text = explain(lookup_, 0.1);
  EXPECT_NE(std::string::npos, text.find("250 ms older than the image, 100 ms were waited for it")) << text;
  EXPECT_NE(std::string::npos, text.find("~tf_patience")) << text;
}

TEST_F(Lookup, refusesWhatIsNotAPosition) {
  for (const double x : {1e39, -1e39, std::numeric_limits<double>::infinity(), 1e9}) {
    tf2::BufferCore buffer;
    geometry_msgs::TransformStamped message;
    message.header.frame_id = "world";
    message.child_frame_id = "camera";
    message.transform.translation.y = x;
    message.transform.rotation.w = 1.0;
    ASSERT_TRUE(buffer.setTransform(message, "test", true));
    const TransformLookup found = lookUp(buffer, "world", "camera", ros::Time(5.0));
    EXPECT_EQ(Status::kMissing, found.status) << x;
    EXPECT_FALSE(found.problem.empty());
  }
}

TEST(ClockJumpDetector, tellsWhenTheStampsOfAFrameFall) {
  ClockJumpDetector clock;
  const auto at = [&clock](const char* child, double seconds) {
    return clock.jumpedBack(child, ros::Time(seconds));
  };
  EXPECT_FALSE(at("camera", 1000.0));
  EXPECT_FALSE(at("late", 500.0)) << "a publisher that is always late";
  EXPECT_FALSE(at("camera", 1001.0));
  EXPECT_FALSE(at("late", 501.0));
  EXPECT_FALSE(at("camera", 995.0)) << "out of order, within what tf holds";
  EXPECT_TRUE(at("camera", 990.0)) << "compared with the newest";
  EXPECT_FALSE(at("late", 300.0)) << "the clock of all frames went back";
  EXPECT_FALSE(at("camera", 990.1));
  EXPECT_TRUE(at("camera", 1.0));
  EXPECT_FALSE(at("camera", 5000.0)) << "forward";
}

}  // namespace
}  // namespace line_plane_segmentation
