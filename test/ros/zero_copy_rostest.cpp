// SPDX-License-Identifier: BSD-3-Clause
// Between nodelets of one manager neither images nor results are copied. This program acts as manager,
// camera and subscriber.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <nodelet/loader.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/make_shared.hpp>
#include <vector>

#include "test_camera.h"

namespace {

// Number of marker arrays that were deserialised.
int deserialized_markers = 0;

}  // namespace

// roscpp calls this before it deserialises a message; for a message passed as a pointer it is not called.
namespace ros {
namespace serialization {
template <>
struct PreDeserialize<visualization_msgs::MarkerArray> {
  static void notify(const PreDeserializeParams<visualization_msgs::MarkerArray>&) { ++deserialized_markers; }
};
}  // namespace serialization
}  // namespace ros

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 240;

class ZeroCopy : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(loader_.load("/plane_segmenter", "line_plane_segmentation/plane_segmenter", {}, {}));
    ASSERT_TRUE(
        waitUntil([this] { return images_.getNumSubscribers() == 1 && infos_.getNumSubscribers() == 1; }));
  }

  ros::NodeHandle nh_;
  ros::Publisher images_ = nh_.advertise<sensor_msgs::Image>("depth/image_rect", 1);
  ros::Publisher infos_ = nh_.advertise<sensor_msgs::CameraInfo>("depth/camera_info", 1);
  nodelet::Loader loader_{false};
  Inbox<PlaneArray> planes_{"plane_segmenter/planes"};
  Inbox<sensor_msgs::Image> labels_{"plane_segmenter/labels"};
  Inbox<sensor_msgs::Image> overlay_{"plane_segmenter/overlay"};
  Inbox<sensor_msgs::PointCloud2> cloud_{"plane_segmenter/cloud"};
  Inbox<visualization_msgs::MarkerArray> markers_{"plane_segmenter/markers"};
  Inbox<visualization_msgs::MarkerArray> scanlines_{"plane_segmenter/scanlines"};
};

TEST_F(ZeroCopy, readsTheVeryImageAndPassesOnTheVeryResults) {
  // If the message were serialised, roscpp would replace this by the publisher's own sequence number.
  constexpr std::uint32_t kNeverCounted = 123456;
  const ros::Time stamp(17.0);
  const auto image = boost::make_shared<sensor_msgs::Image>(testImage(kWidth, kHeight, "16UC1"));
  image->header.stamp = stamp;
  image->header.seq = kNeverCounted;
  images_.publish(sensor_msgs::ImageConstPtr(image));

  // The segmenter holds the image until its camera_info arrives.
  ASSERT_TRUE(waitUntil([&] { return image.use_count() == 2; }, 5.0));
  spinFor(0.5);
  ASSERT_EQ(2, image.use_count());

  // A publisher must not modify a published message; here it shows which bytes are read.
  image->data = imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5).data;
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>(testInfo(kWidth, kHeight));
  info->header.stamp = stamp;
  infos_.publish(sensor_msgs::CameraInfoConstPtr(info));

  ASSERT_TRUE(planes_.waitFor(stamp));
  EXPECT_EQ(1U, planes_.newest()->planes.size());
  ASSERT_TRUE(labels_.waitFor(stamp));
  ASSERT_TRUE(overlay_.waitFor(stamp));
  ASSERT_TRUE(cloud_.waitFor(stamp));
  EXPECT_EQ(kNeverCounted, planes_.newest()->header.seq);
  EXPECT_EQ(kNeverCounted, labels_.newest()->header.seq);
  EXPECT_EQ(kNeverCounted, overlay_.newest()->header.seq);
  EXPECT_EQ(kNeverCounted, cloud_.newest()->header.seq);
  // Marker arrays have no sequence number.
  ASSERT_TRUE(waitUntil([&] { return markers_.count() == 1 && scanlines_.count() == 1; }));
  EXPECT_FALSE(markers_.newest()->markers.empty());
  EXPECT_FALSE(scanlines_.newest()->markers.empty());
  EXPECT_EQ(0, deserialized_markers);
  EXPECT_TRUE(waitUntil([&] { return image.use_count() == 1; })) << "the image is kept for ever";
}

template <typename Message>
std::vector<std::uint8_t> bytesOf(const Message& message) {
  const ros::SerializedMessage serialized = ros::serialization::serializeMessage(message);
  return {serialized.buf.get(), serialized.buf.get() + serialized.num_bytes};
}

TEST_F(ZeroCopy, theImageIsAtOneAddressForAll) {
  const Inbox<sensor_msgs::Image> others("depth/image_rect");
  const auto image = boost::make_shared<const sensor_msgs::Image>(testImage(kWidth, kHeight, "16UC1"));
  images_.publish(image);
  ASSERT_TRUE(waitUntil([&] { return others.count() == 1; }));
  EXPECT_EQ(image.get(), others.newest().get());
}

// A subscriber may keep a message for any time.
TEST_F(ZeroCopy, whatHasBeenPublishedStaysAsItIs) {
  const auto publish = [this](double stamp, double distance) {
    sensor_msgs::Image image =
        imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), distance);
    sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);
    image.header.stamp = info.header.stamp = ros::Time(stamp);
    const int markers = markers_.count(), scanlines = scanlines_.count();
    images_.publish(image);
    infos_.publish(info);
    return planes_.waitFor(ros::Time(stamp)) && labels_.waitFor(ros::Time(stamp)) &&
           overlay_.waitFor(ros::Time(stamp)) && cloud_.waitFor(ros::Time(stamp)) &&
           waitUntil([&] { return markers_.count() > markers && scanlines_.count() > scanlines; });
  };
  ASSERT_TRUE(publish(20.0, 1.5));
  const auto planes = planes_.newest();
  const auto labels = labels_.newest();
  const auto overlay = overlay_.newest();
  const auto cloud = cloud_.newest();
  const auto markers = markers_.newest(), scanlines = scanlines_.newest();
  const auto contents = [&] {
    return std::vector<std::vector<std::uint8_t>>{bytesOf(*planes), bytesOf(*labels),  bytesOf(*overlay),
                                                  bytesOf(*cloud),  bytesOf(*markers), bytesOf(*scanlines)};
  };
  const auto before = contents();
  for (int i = 1; i <= 5; ++i) ASSERT_TRUE(publish(20.0 + i, 1.5 + 0.2 * i));
  EXPECT_NE(before[0], bytesOf(*planes_.newest())) << "the images are too much alike to show anything";
  EXPECT_EQ(before, contents());

  // No message is kept for later subscribers, which would hold memory permanently.
  const Inbox<PlaneArray> late_planes("plane_segmenter/planes");
  const Inbox<sensor_msgs::Image> late_labels("plane_segmenter/labels"),
      late_overlay("plane_segmenter/overlay");
  const Inbox<sensor_msgs::PointCloud2> late_cloud("plane_segmenter/cloud");
  const Inbox<visualization_msgs::MarkerArray> late_markers("plane_segmenter/markers"),
      late_scanlines("plane_segmenter/scanlines");
  spinFor(0.5);
  EXPECT_EQ(0, late_planes.count() + late_labels.count() + late_overlay.count() + late_cloud.count() +
                   late_markers.count() + late_scanlines.count());
}

}  // namespace
}  // namespace line_plane_segmentation
