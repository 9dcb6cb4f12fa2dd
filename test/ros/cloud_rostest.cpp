// SPDX-License-Identifier: BSD-3-Clause
// Point clouds instead of depth images.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/PointCloud2.h>

#include <cmath>
#include <string>

#include "test_camera.h"
#include "test_clouds.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;
const Eigen::Vector3d kNormal = Eigen::Vector3d(0.2, -0.4, -1.0).normalized();
constexpr double kDistance = 1.4;

class Cloud : public testing::Test {
 protected:
  Cloud() { setPlane(good_, testCamera(kWidth, kHeight), kNormal, kDistance); }

  bool waitForSubscriber() {
    return waitUntil([this] { return publisher_.getNumSubscribers() == 1; });
  }

  void publish(sensor_msgs::PointCloud2 cloud, double seconds) {
    cloud.header.stamp = ros::Time(seconds);
    publisher_.publish(cloud);
  }

  // True if the message of the newest report begins with this text.
  bool diagnosticsSay(const std::string& text) const {
    return waitUntil([&] { return diagnostics_.newest().message.find(text) == 0; });
  }

  ros::NodeHandle nh_;
  ros::Publisher publisher_ = nh_.advertise<sensor_msgs::PointCloud2>("depth/points", 10);
  sensor_msgs::PointCloud2 good_ = testCloud(kWidth, kHeight);
  Diagnostics diagnostics_;
};

TEST_F(Cloud, isReadOnlyWhileItIsWanted) {
  spinFor(0.5);
  EXPECT_EQ(0U, publisher_.getNumSubscribers());
  {
    const Inbox<PlaneArray> planes("plane_segmenter/planes");
    EXPECT_TRUE(waitForSubscriber());
    EXPECT_TRUE(diagnosticsSay("waiting for point clouds on /depth/points"));
  }
  EXPECT_TRUE(waitUntil([this] { return publisher_.getNumSubscribers() == 0; }));
}

TEST_F(Cloud, givesPlanesAndAllElse) {
  const Inbox<PlaneArray> planes("plane_segmenter/planes");
  const Inbox<sensor_msgs::Image> labels("plane_segmenter/labels");
  const Inbox<sensor_msgs::Image> overlay("plane_segmenter/overlay");
  const Inbox<sensor_msgs::PointCloud2> cloud("plane_segmenter/cloud");
  ASSERT_TRUE(waitForSubscriber());
  double seconds = 100.0;
  ASSERT_TRUE(waitUntil([&] {
    publish(good_, seconds += 0.1);
    spinFor(0.1);
    return planes.newest() && labels.newest() && overlay.newest() && cloud.newest();
  }));
  ASSERT_TRUE(planes.waitFor(ros::Time(seconds)));
  EXPECT_EQ(kCameraFrame, planes.newest()->header.frame_id);
  EXPECT_EQ(kWidth, planes.newest()->image_width);
  EXPECT_EQ(kHeight, planes.newest()->image_height);
  ASSERT_EQ(1U, planes.newest()->planes.size());
  const auto& coef = planes.newest()->planes[0].coefficients.coef;
  EXPECT_GT(Eigen::Vector3d(coef[0], coef[1], coef[2]).dot(kNormal), std::cos(0.1 * M_PI / 180.0));
  EXPECT_NEAR(kDistance, coef[3], 0.001);
  EXPECT_EQ(kWidth, cloud.newest()->width);
  EXPECT_EQ(kHeight, labels.newest()->height);
}

TEST_F(Cloud, thatIsNoneIsRefusedWithAClearWord) {
  const Inbox<PlaneArray> planes("plane_segmenter/planes");
  ASSERT_TRUE(waitForSubscriber());
  sensor_msgs::PointCloud2 list = good_;
  list.row_step = list.point_step * kWidth * kHeight;
  list.width = kWidth * kHeight;
  list.height = 1;
  publish(list, 200.0);
  EXPECT_TRUE(diagnosticsSay("refused (unorganized): the cloud is unorganized, a list of 76800 points"));

  sensor_msgs::PointCloud2 level = testCloud(kWidth, kHeight);
  setPlane(level, testCamera(kWidth, kHeight), kNormal, kDistance);
  std::swap(level.fields[0].offset, level.fields[2].offset);
  publish(level, 201.0);
  EXPECT_TRUE(diagnosticsSay("refused (not_pinhole)"));
  EXPECT_EQ(0, planes.count());

  publish(good_, 202.0);
  EXPECT_TRUE(planes.waitFor(ros::Time(202.0)));
  EXPECT_TRUE(diagnosticsSay("segmenting"));
}

}  // namespace
}  // namespace line_plane_segmentation
