// SPDX-License-Identifier: BSD-3-Clause
// segment_bag on bags as robots, drivers and viewers record them.
#include "ros/compressed_depth_messages.h"
#include "segment_bag_fixture.h"

namespace line_plane_segmentation {
namespace {

std::vector<std::uint16_t> numbersOf(const sensor_msgs::Image& image) {
  std::vector<std::uint16_t> numbers(image.data.size() / 2);
  std::memcpy(numbers.data(), image.data.data(), image.data.size());
  return numbers;
}

TEST_F(SegmentBagInput, TakesCompressedDepth) {
  for (const std::string format :
       {"16UC1; compressedDepth", "16UC1; compressedDepth rvl", "32FC1; compressedDepth png"}) {
    {
      rosbag::Bag bag(in(), rosbag::bagmode::Write);
      for (int i = 0; i < 3; ++i) {
        // Inverse depth is quantised: depth = 3 / number.
        const std::vector<std::uint16_t> millimetres = numbersOf(wallImage(i));
        std::vector<std::uint16_t> numbers = millimetres;
        if (format[0] == '3') {
          for (auto& number : numbers) number = static_cast<std::uint16_t>(3e7 / number);
        }
        auto message = compressedDepth(numbers, kBagWidth, kBagHeight, format, 3e4F, 0.0F);
        message.header = wallImage(i).header;
        bag.write(kDepth + std::string("/compressedDepth"), recordingTime(i), message);
        bag.write(kInfo, recordingTime(i), wallInfo(i));
      }
      bag.close();
    }
    SCOPED_TRACE(format);
    expectWalls(run(), 3);
    expectWalls(run({"--topic", kDepth}), 3);
    expectWalls(run({"--topic", kDepth + std::string("/compressedDepth")}), 3);
  }
}

TEST_F(SegmentBagInput, PrefersTheRawImagesOfABagWithBoth) {
  writeBag([](rosbag::Bag& bag, int i) {
    bag.write(kInfo, recordingTime(i), wallInfo(i));
    auto message =
        compressedDepth(numbersOf(wallImage(i, 900)), kBagWidth, kBagHeight, "16UC1; compressedDepth");
    message.header = wallImage(i).header;
    bag.write(kDepth + std::string("/compressedDepth"), recordingTime(i), message);
  });
  expectWalls(run(), kFrames);
  EXPECT_EQ(countTopics(out()).size(), 1U);
}

TEST_F(SegmentBagInput, RefusesPixelsThatCannotBeDecoded) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    for (int i = 0; i < 3; ++i) {
      auto message =
          compressedDepth(numbersOf(wallImage(i)), kBagWidth, kBagHeight, "16UC1; compressedDepth");
      message.header = wallImage(i).header;
      if (i == 1) message.data.resize(message.data.size() / 2);
      bag.write(kDepth + std::string("/compressedDepth"), recordingTime(i), message);
      bag.write(kInfo, recordingTime(i), wallInfo(i));
    }
    bag.close();
  }
  const ToolResult result = run();
  EXPECT_NE(result.out.find("2 frames, 2 planes, 1 refused: the pixels of a compressed image"),
            std::string::npos)
      << result.out << result.err;
}

TEST_F(SegmentBagInput, TakesMono16WhereTheTopicSaysDepth) {
  writeBag(writeInfoOn(kInfo), kDepth, "mono16");
  expectWalls(run(), kFrames);
  std::filesystem::remove(out());
  writeBag(writeInfoOn("/camera/ir/camera_info"), "/camera/ir/image", "mono16");
  expectRefused(run(), {"/camera/ir/image (mono16)", "--topic /camera/ir/image"});
}

TEST_F(SegmentBagInput, TakesCameraInfoThatIsRecordedOnce) {
  for (const double stamp : {0.0, 1000.0, 77.0}) {
    SCOPED_TRACE(stamp);
    writeBag([stamp](rosbag::Bag& bag, int i) {
      sensor_msgs::CameraInfo info = wallInfo(0);
      info.header.stamp = ros::Time(stamp);
      if (i == 0) bag.write(kInfo, recordingTime(0), info);
    });
    const ToolResult result = run();
    expectWalls(result, kFrames);
    EXPECT_NE(result.out.find("with the newest camera_info of " + std::string(kInfo)), std::string::npos)
        << result.out;
  }
}

TEST_F(SegmentBagInput, TakesCameraInfoWithOtherStamps) {
  for (const ros::Duration off : {ros::Duration(0.004), ros::Duration(-0.004)}) {
    writeBag([off](rosbag::Bag& bag, int i) {
      sensor_msgs::CameraInfo info = wallInfo(i);
      info.header.stamp += off;
      bag.write(kInfo, recordingTime(i), info);
    });
    expectWalls(run(), kFrames);
  }
  writeBag([](rosbag::Bag& bag, int i) {
    sensor_msgs::CameraInfo info = wallInfo(i);
    info.header.stamp = ros::Time();
    bag.write(kInfo, recordingTime(i), info);
  });
  expectWalls(run(), kFrames);
  expectWalls(run({"--set", "info_matching=latest"}), kFrames);
  std::filesystem::remove(out());
  expectRefused(
      run({"--set", "info_matching=exact"}),
      {"none of the 40 images of /camera/depth/image_raw has a camera_info on " + std::string(kInfo),
       "--camera FX,FY,CX,CY"});
}

TEST_F(SegmentBagInput, FindsCameraInfoOfTheSameFrameUnderAnyName) {
  writeBag(writeInfoOn("/calibration/depth"));
  expectWalls(run(), kFrames);
}

TEST_F(SegmentBagInput, TakesCameraInfoFromTheNamedTopic) {
  const auto write_of_another_frame = [](rosbag::Bag& bag, int i) {
    sensor_msgs::CameraInfo info = wallInfo(i);
    info.header.frame_id = "left";
    bag.write("/left/camera_info", recordingTime(i), info);
  };
  writeBag(write_of_another_frame);
  expectRefused(run(), {"--info-topic", "/left/camera_info"});
  expectWalls(run({"--info-topic", "/left/camera_info"}), kFrames);
  expectWalls(run({"--topic", kDepth, "--info-topic", "left/camera_info"}), kFrames);
  std::filesystem::remove(out());
  expectRefused(run({"--info-topic", "/nothing"}), {"has no topic /nothing"});
  expectRefused(run({"--info-topic", kDepth}), {"is sensor_msgs/Image, not sensor_msgs/CameraInfo"});
  expectRefused(run({"--topic", kDepth, "--info-topic", "/a", "--info-topic", "/b"}),
                {"as often as --topic"});
}

TEST_F(SegmentBagInput, TakesIntrinsicsFromTheCommandLine) {
  writeBag(writeNoInfo());
  expectRefused(run(), {"has a camera_info; there is none: give the intrinsics with --camera FX,FY,CX,CY"});
  expectWalls(run({"--camera", "131.25,131.25,79.5,59.5"}), kFrames);
  std::filesystem::remove(out());
  expectRefused(run({"--camera", "131.25,131.25"}), {"FX,FY,CX,CY"});
  expectRefused(run({"--camera", "1,1,1,1", "--info-topic", kInfo}), {"give one of them"});
}

// As RealSense's viewer does: mono16, camera_info once, without stamp, frame or P, one folder away.
TEST_F(SegmentBagInput, TakesBagsOfTheRealSenseViewer) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    sensor_msgs::CameraInfo info = wallInfo(0);
    info.header = {};
    info.P.fill(0.0);
    const std::string sensor = "/device_0/sensor_0/Depth_0/";
    bag.write(sensor + "info/camera_info", ros::TIME_MIN, info);
    bag.write("/device_0/sensor_1/Color_0/info/camera_info", ros::TIME_MIN, info);
    for (int i = 0; i < 2; ++i) {
      sensor_msgs::Image image = wallImage(i);
      image.header.frame_id = "0";
      image.encoding = "mono16";
      bag.write(sensor + "image/data", recordingTime(i), image);
      image.encoding = "rgb8";
      bag.write("/device_0/sensor_1/Color_0/image/data", recordingTime(i), image);
    }
    bag.close();
  }
  expectWalls(run(), 2, "/device_0/sensor_0/Depth_0/plane_segmenter/planes");
}

TEST_F(SegmentBagInput, TakesAnyUnit) {
  writeBag(writeInfoOn(kInfo));
  expectWalls(run({"--set", "depth_unit=0.0005"}), kFrames, kPlanes, 0.75);
  std::filesystem::remove(out());
  expectRefused(run({"--set", "depth_unit=nan"}), {"depth_unit = nan is outside"});
  expectRefused(run({"--set", "max_pixels=0"}), {"max_pixels = 0 is outside"});
  expectRefused(run({"--set", "max_pixels=100"}), {"too large"});
}

TEST_F(SegmentBagInput, SaysWhatIsThereIfThereIsNoDepth) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    sensor_msgs::Image image = wallImage(0);
    image.encoding = "bgr8";
    bag.write("/camera/rgb/image_color", recordingTime(0), image);
    sensor_msgs::CompressedImage jpeg;
    jpeg.format = "bgr8; jpeg compressed bgr8";
    bag.write("/camera/rgb/image_color2/compressed", recordingTime(0), jpeg);
    bag.close();
  }
  expectRefused(run(), {"holds no depth images", "/camera/rgb/image_color (bgr8)",
                        "/camera/rgb/image_color2/compressed (bgr8; jpeg"});
  expectRefused(run({"--topic", "/camera/depth/image_raw"}),
                {"has no topic /camera/depth/image_raw; its images are /camera/rgb/image_color"});
}

}  // namespace
}  // namespace line_plane_segmentation
