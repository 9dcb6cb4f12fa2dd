// SPDX-License-Identifier: BSD-3-Clause
// All outputs for one image, as documented.
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <limits>
#include <string>

#include "test_camera.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 640;
constexpr std::uint32_t kHeight = 480;

// A tilted floor, seen by a camera that looks down.
const Eigen::Vector3d kNormal = Eigen::Vector3d(0.2, -0.4, -1.0).normalized();
constexpr double kDistance = 1.4;

// The newest markers of a topic; a MarkerArray has no header of its own.
class MarkerInbox {
 public:
  explicit MarkerInbox(const std::string& topic)
      : subscriber_(ros::NodeHandle().subscribe<visualization_msgs::MarkerArray>(
            topic, 10,
            [this](const visualization_msgs::MarkerArray::ConstPtr& message) { newest_ = message; })) {}
  MarkerInbox(const MarkerInbox&) = delete;
  MarkerInbox& operator=(const MarkerInbox&) = delete;

  const visualization_msgs::MarkerArray::ConstPtr& newest() const { return newest_; }
  bool waitFor(const ros::Time& stamp) const {
    return waitUntil([&] { return newest_->markers.front().header.stamp == stamp; });
  }

 private:
  visualization_msgs::MarkerArray::ConstPtr newest_;
  ros::Subscriber subscriber_;
};

class SegmentationTest : public testing::Test {
 protected:
  SegmentationTest() { EXPECT_TRUE(camera_.waitForSubscriber()); }

  // Returns a new timestamp for each frame.
  static ros::Time nextStamp() {
    static double seconds = 1000.0;
    return ros::Time(seconds += 0.1);
  }

  void publishGood(const ros::Time& stamp) { camera_.publish(good_, info_, stamp); }

  void expectAnswer(const ros::Time& stamp) {
    EXPECT_TRUE(planes_.waitFor(stamp)) << "no planes at " << stamp;
  }

  // Checks the newest messages.
  void expectThePlane() const {
    ASSERT_TRUE(planes_.newest());
    ASSERT_EQ(1U, planes_.newest()->planes.size());
    const auto& coef = planes_.newest()->planes[0].coefficients.coef;
    EXPECT_GT(Eigen::Vector3d(coef[0], coef[1], coef[2]).dot(kNormal), std::cos(0.5 * M_PI / 180.0));
    EXPECT_NEAR(kDistance, coef[3], 0.005);
    EXPECT_GE(planes_.newest()->planes[0].inliers, kWidth * kHeight * 9 / 10);
    EXPECT_GE(planes_.newest()->planes[0].outline.points.size(), 3U);
  }

  TestCamera camera_;
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  sensor_msgs::Image good_ = imageOfPlane(kWidth, kHeight, "16UC1", kNormal, kDistance);
  sensor_msgs::CameraInfo info_ = testInfo(kWidth, kHeight);
};

TEST_F(SegmentationTest, findsThePlaneInEachEncoding) {
  for (const char* encoding : {"16UC1", "mono16", "32FC1"}) {
    SCOPED_TRACE(encoding);
    const ros::Time stamp = nextStamp();
    camera_.publish(imageOfPlane(kWidth, kHeight, encoding, kNormal, kDistance), info_, stamp);
    expectAnswer(stamp);
    EXPECT_EQ(kCameraFrame, planes_.newest()->header.frame_id);
    EXPECT_EQ(kWidth, planes_.newest()->image_width);
    EXPECT_EQ(kHeight, planes_.newest()->image_height);
    EXPECT_GT(planes_.newest()->processing_time, 0.0F);
    expectThePlane();
  }
}

TEST_F(SegmentationTest, answersOnEveryTopic) {
  const Inbox<sensor_msgs::Image> labels("plane_segmenter/labels");
  const Inbox<sensor_msgs::Image> overlay("plane_segmenter/overlay");
  const Inbox<sensor_msgs::PointCloud2> cloud("plane_segmenter/cloud");
  const MarkerInbox markers("plane_segmenter/markers");
  const MarkerInbox scanlines("plane_segmenter/scanlines");
  // The camera cannot see subscribers of the other outputs: publish until all are connected.
  ros::Time stamp;
  ASSERT_TRUE(waitUntil([&] {
    stamp = nextStamp();
    publishGood(stamp);
    spinFor(0.1);
    return labels.newest() && overlay.newest() && cloud.newest() && markers.newest() && scanlines.newest();
  }));
  stamp = nextStamp();
  publishGood(stamp);
  expectAnswer(stamp);
  ASSERT_TRUE(labels.waitFor(stamp));
  ASSERT_TRUE(overlay.waitFor(stamp));
  ASSERT_TRUE(cloud.waitFor(stamp));
  ASSERT_TRUE(markers.waitFor(stamp));
  ASSERT_TRUE(scanlines.waitFor(stamp));

  EXPECT_EQ(kCameraFrame, labels.newest()->header.frame_id);
  EXPECT_EQ("16UC1", labels.newest()->encoding);
  EXPECT_EQ(std::size_t{2} * kWidth * kHeight, labels.newest()->data.size());
  EXPECT_EQ(kCameraFrame, overlay.newest()->header.frame_id);
  EXPECT_EQ("rgb8", overlay.newest()->encoding);
  EXPECT_EQ(std::size_t{3} * kWidth * kHeight, overlay.newest()->data.size());
  EXPECT_EQ(kCameraFrame, cloud.newest()->header.frame_id);
  EXPECT_EQ(kWidth, cloud.newest()->width);
  EXPECT_EQ(kHeight, cloud.newest()->height);
  EXPECT_EQ(kCameraFrame, markers.newest()->markers.front().header.frame_id);
  EXPECT_EQ(4U, markers.newest()->markers.size());
  EXPECT_EQ(kCameraFrame, scanlines.newest()->markers.front().header.frame_id);
  EXPECT_EQ(4U, scanlines.newest()->markers.size());

  std::size_t labelled = 0;
  for (std::size_t i = 0; i < labels.newest()->data.size(); i += 2) {
    labelled += labels.newest()->data[i] == planes_.newest()->planes.at(0).label ? 1 : 0;
  }
  EXPECT_EQ(planes_.newest()->planes.at(0).inliers, labelled);
}

TEST_F(SegmentationTest, takesImagesOfChangingSize) {
  for (const std::uint32_t width : {320U, 640U, 160U}) {
    const ros::Time stamp = nextStamp();
    const std::uint32_t height = width * 3 / 4;
    camera_.publish(imageOfPlane(width, height, "16UC1", kNormal, kDistance), testInfo(width, height), stamp);
    expectAnswer(stamp);
    EXPECT_EQ(width, planes_.newest()->image_width);
    EXPECT_EQ(1U, planes_.newest()->planes.size()) << width;
  }
}

TEST_F(SegmentationTest, answersEveryFrameOfACamera) {
  const int answers = planes_.count();
  for (int i = 0; i < 60; ++i) {
    publishGood(nextStamp());
    // As a camera at 30 Hz, but no faster than this machine answers: at most two frames are under way.
    spinFor(1.0 / 30.0);
    EXPECT_TRUE(waitUntil([&] { return planes_.count() >= answers + i - 1; })) << planes_.count() - answers;
  }
  EXPECT_TRUE(waitUntil([&] { return planes_.count() == answers + 60; })) << planes_.count() - answers;
}

TEST_F(SegmentationTest, isReconfiguredWhileItRuns) {
  const auto set = [](double max_range) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(2);
    call.request.config.doubles[0].name = "max_range";
    call.request.config.doubles[0].value = max_range;
    call.request.config.doubles[1].name = "plane_distance";
    call.request.config.doubles[1].value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(ros::service::call("plane_segmenter/set_parameters", call));
    for (const auto& value : call.response.config.doubles) {
      EXPECT_FALSE(std::isnan(value.value)) << value.name;
      if (value.name == "max_range") {
        EXPECT_EQ(max_range, value.value);
      }
    }
  };
  set(0.8);
  ros::Time stamp = nextStamp();
  publishGood(stamp);
  expectAnswer(stamp);
  EXPECT_TRUE(planes_.newest()->planes.empty());

  set(10.0);
  stamp = nextStamp();
  publishGood(stamp);
  expectAnswer(stamp);
  expectThePlane();
}

}  // namespace
}  // namespace line_plane_segmentation
