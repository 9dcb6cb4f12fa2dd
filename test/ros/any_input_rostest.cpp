// SPDX-License-Identifier: BSD-3-Clause
// Cameras as they are: every image is answered, whatever its camera_info, its codec and its unit are.
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <rosgraph_msgs/Log.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compressed_depth_messages.h"
#include "test_camera.h"
#include "test_reports.h"

namespace line_plane_segmentation {
namespace {

constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 120;
constexpr int kFrames = 40;

ros::Time stampOfFrame(int i) { return ros::Time(1000.0) + ros::Duration(0.05 * i); }

// A segmenter and its camera in a namespace of their own.
struct Side {
  explicit Side(const std::string& name)
      : camera(name, 100),
        planes(std::make_unique<Inbox<PlaneArray>>(name + "/plane_segmenter/planes")),
        diagnostics(name + "/plane_segmenter") {}

  bool isReady() const { return camera.waitForSubscriber(); }

  // Publishes images at 20 Hz, and with each what `publish_info` does. Returns how many were answered.
  int answered(const std::function<void(int)>& publish_info) {
    for (int i = 0; i < kFrames; ++i) {
      publish_info(i);
      camera.publishImage(image, stampOfFrame(i));
      spinFor(0.05);
    }
    waitUntil([this] { return planes->count() == kFrames; }, 5.0);
    return planes->count();
  }

  TestCamera camera;
  std::unique_ptr<Inbox<PlaneArray>> planes;
  Diagnostics diagnostics;
  sensor_msgs::Image image = imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 1.5);
  sensor_msgs::CameraInfo info = testInfo(kWidth, kHeight);
};

// Warnings with this text.
class Warnings {
 public:
  explicit Warnings(const std::string& text)
      : subscriber_(ros::NodeHandle().subscribe<rosgraph_msgs::Log>(
            "/rosout", 1000, [this, text](const rosgraph_msgs::Log::ConstPtr& line) {
              if (line->level == rosgraph_msgs::Log::WARN && line->msg.find(text) != std::string::npos)
                ++count_;
            })) {
    // This program and the manager.
    EXPECT_TRUE(waitUntil([this] { return subscriber_.getNumPublishers() >= 2; }));
  }
  int count() const { return count_; }

 private:
  int count_ = 0;
  ros::Subscriber subscriber_;
};

TEST(AnyInput, cameraInfoThatIsSentOnce) {
  Side side("once");
  ASSERT_TRUE(side.isReady());
  const auto once = [&](int i) {
    if (i == 0) side.camera.publishInfo(side.info, ros::Time(500.0));
  };
  EXPECT_EQ(kFrames, side.answered(once));

  // Who comes later finds it remembered.
  side.planes.reset();
  ASSERT_TRUE(side.camera.waitForIdle());
  Inbox<PlaneArray> later("once/plane_segmenter/planes");
  ASSERT_TRUE(side.isReady());
  EXPECT_TRUE(waitUntil([&] {
    side.camera.publishImage(side.image, ros::Time(2000.0));
    spinFor(0.1);
    return later.count() > 0;
  }));
}

TEST(AnyInput, cameraInfoThatIsOff) {
  const Warnings warnings("no camera_info on /off/depth/camera_info has the stamp of an image");
  Side side("off");
  ASSERT_TRUE(side.isReady());
  const auto off = [&](int i) { side.camera.publishInfo(side.info, stampOfFrame(i) + ros::Duration(0.004)); };
  EXPECT_EQ(kFrames, side.answered(off));
  EXPECT_TRUE(side.diagnostics.waitForValue("camera_info", "the newest: none has the stamp of an image"));
  EXPECT_EQ("0", side.diagnostics.value("images without camera_info"));
  EXPECT_EQ(1, warnings.count());

  // As soon as there are pairs, all is as usual.
  side.camera.publish(side.image, side.info, ros::Time(3000.0));
  EXPECT_TRUE(side.diagnostics.waitForValue("camera_info", "that of the image's stamp"));
}

TEST(AnyInput, cameraInfoWithoutStamp) {
  Side side("zero");
  ASSERT_TRUE(side.isReady());
  EXPECT_EQ(kFrames, side.answered([&](int) { side.camera.publishInfo(side.info, ros::Time()); }));
}

TEST(AnyInput, latestWaitsForNothing) {
  Side side("latest");
  ASSERT_TRUE(side.isReady());
  side.camera.publishInfo(side.info, ros::Time(1.0));
  ASSERT_TRUE(waitUntil(
      [&] {
        side.camera.publishImage(side.image, ros::Time(2.0));
        spinFor(0.05);
        return side.planes->count() > 0;
      },
      0.9))
      << "a second has gone by";
}

// As over a slow link, where the images are held up: 60 of them are on their way.
TEST(AnyInput, imagesThatLagBehind) {
  Side side("lag");
  ASSERT_TRUE(side.isReady());
  constexpr int kLag = 60;
  for (int i = 0; i < kLag; ++i) side.camera.publishInfo(side.info, stampOfFrame(i));
  EXPECT_EQ(kFrames,
            side.answered([&](int i) { side.camera.publishInfo(side.info, stampOfFrame(i + kLag)); }));
  EXPECT_TRUE(side.diagnostics.waitForValue("camera_info", "that of the image's stamp"));
}

TEST(AnyInput, cameraInfoOnAnotherTopic) {
  Side side("remapped");
  const ros::Publisher infos =
      ros::NodeHandle().advertise<sensor_msgs::CameraInfo>("remapped/calibration", 10);
  ASSERT_TRUE(waitUntil([&] { return side.camera.imageSubscribers() > 0 && infos.getNumSubscribers() > 0; }));
  side.info.header.stamp = ros::Time(5.0);
  infos.publish(side.info);
  side.camera.publishImage(side.image, ros::Time(5.0));
  EXPECT_TRUE(side.planes->waitFor(ros::Time(5.0)));
  EXPECT_EQ(0U, side.camera.infoSubscribers());
  EXPECT_TRUE(side.diagnostics.waitForValue("camera_info topic", "/remapped/calibration"));
}

TEST(AnyInput, compressedDepth) {
  Side side("compressed");
  const ros::Publisher images = ros::NodeHandle().advertise<sensor_msgs::CompressedImage>(
      "compressed/depth/image_rect/compressedDepth", 10);
  ASSERT_TRUE(waitUntil([&] { return images.getNumSubscribers() > 0 && side.camera.infoSubscribers() > 0; }));
  const std::vector<std::uint16_t> millimetres(kWidth * kHeight, 1500);
  ros::Time stamp(5.0);
  for (const char* format : {"16UC1; compressedDepth png", "16UC1; compressedDepth rvl"}) {
    sensor_msgs::CompressedImage message = compressedDepth(millimetres, kWidth, kHeight, format);
    message.header.frame_id = kCameraFrame;
    message.header.stamp = (stamp += ros::Duration(1.0));
    side.camera.publishInfo(side.info, message.header.stamp);
    images.publish(message);
    ASSERT_TRUE(side.planes->waitFor(message.header.stamp)) << format;
    ASSERT_EQ(1U, side.planes->newest()->planes.size());
    EXPECT_NEAR(1.5, side.planes->newest()->planes[0].coefficients.coef[3], 0.002);
  }
}

TEST(AnyInput, anotherUnit) {
  Side side("units");
  ASSERT_TRUE(side.isReady());
  const sensor_msgs::Image image =
      imageOfPlane(kWidth, kHeight, "16UC1", Eigen::Vector3d(0.0, 0.0, -1.0), 15.0);
  side.camera.publish(image, side.info, ros::Time(5.0));
  ASSERT_TRUE(side.planes->waitFor(ros::Time(5.0)));
  ASSERT_EQ(1U, side.planes->newest()->planes.size());
  EXPECT_NEAR(1.5, side.planes->newest()->planes[0].coefficients.coef[3], 0.002);
}

}  // namespace
}  // namespace line_plane_segmentation
