// SPDX-License-Identifier: BSD-3-Clause
// segment_bag on bags without useful recording times, when it is asked to end, and on recorded data.
#include <cstdlib>
#include <utility>

#include "segment_bag_fixture.h"

namespace line_plane_segmentation {
namespace {

using SegmentBagLimits = SegmentBagInput;

// rosbag gives messages of one recording time topic by topic.
TEST_F(SegmentBagLimits, NeedsNoRecordingTimes) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    for (int i = 0; i < 3 * kFrames; ++i) {
      bag.write(kDepth, recordingTime(0), wallImage(i));
      bag.write(kInfo, recordingTime(0), wallInfo(i));
    }
    bag.close();
  }
  expectWalls(run(), 3 * kFrames);
}

// The frame is never known, and by the recording times it may still come: images must not pile up until then.
TEST_F(SegmentBagLimits, LooksAheadWithinBounds) {
  constexpr int kImages = 700;
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    bag.setCompression(rosbag::compression::LZ4);
    sensor_msgs::Image image = wallImage(0);
    image.width = 1280;
    image.height = 960;
    image.step = 2 * image.width;
    image.data.assign(std::size_t{image.step} * image.height, 5);
    sensor_msgs::CameraInfo info = wallInfo(0);
    info.width = image.width;
    info.height = image.height;
    for (int i = 0; i < kImages; ++i) {
      image.header.stamp = info.header.stamp = stampOf(i);
      const ros::Time time = recordingTime(0) + ros::Duration(1e-6 * i);
      bag.write(kDepth, time, image);
      bag.write(kInfo, time, info);
    }
    bag.close();
  }
  // Of the images there are 1.7 GB.
  const ToolResult result = run({"--set", "gravity_frame=moon"}, "ulimit -v 1400000;");
  EXPECT_NE(result.err.find("gravity_frame 'moon'"), std::string::npos) << result.err;
  ASSERT_TRUE(std::filesystem::exists(out()));
  EXPECT_EQ(countTopics(out()).at(kPlanes), kImages);
}

TEST_F(SegmentBagLimits, EndsOnRequest) {
  writeBag([](rosbag::Bag& bag, int i) {
    for (int k = 0; k < 400; ++k) bag.write("/camera/depth/more", recordingTime(i), wallImage(k));
  });
  for (const char* seconds : {"0.02", "0.2"}) {
    const ToolResult result =
        runProcess("/usr/bin/timeout", {"-s", "INT", "-k", "20", seconds, SEGMENT_BAG, in(), out()});
    EXPECT_EQ(result.exit_code, 124) << "it ended by itself, or had to be killed";
    EXPECT_EQ(namesIn(folder_.path()), std::vector<std::string>{"in.bag"});
  }
}

// Recorded data, which is not part of the repository.
TEST_F(SegmentBagLimits, TakesTheRecordedCases) {
  const std::filesystem::path cases = std::filesystem::path(LPS_TEST_DATA) / "cases";
  const char* ci = std::getenv("CI");
  if (!std::filesystem::exists(cases)) {
    if (ci != nullptr && std::string(ci) == "true") FAIL() << "no folder " << cases << ", set LPS_TEST_DATA";
    GTEST_SKIP() << "no folder " << cases << ", set LPS_TEST_DATA to the folder of the recorded test data";
  }
  const std::pair<const char*, int> kCases[] = {{"compressed_depth.bag", 20}, {"realsense_viewer.bag", 2}};
  for (const auto& [name, frames] : kCases) {
    const ToolResult result = runProcess(SEGMENT_BAG, {(cases / name).string(), out()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    int found = 0;
    for (const auto& [topic, arrays] : readAll<PlaneArray>(out())) found += static_cast<int>(arrays.size());
    EXPECT_EQ(found, frames) << name << ": " << result.out;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
