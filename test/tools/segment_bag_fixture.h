// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.h"
#include "test_bag.h"
#include "tool_process.h"

namespace line_plane_segmentation {

inline constexpr char kDepth[] = "/camera/depth/image_raw";
inline constexpr char kInfo[] = "/camera/depth/camera_info";
inline constexpr char kPlanes[] = "/camera/plane_segmenter/planes";
inline constexpr int kFrames = 40;  // more than images may wait

/// segment_bag, and a bag of a wall for it.
class SegmentBagInput : public testing::Test {
 protected:
  std::string in() const { return (folder_ / "in.bag").string(); }
  std::string out() const { return (folder_ / "out.bag").string(); }

  ToolResult run(const std::vector<std::string>& more = {}, const std::string& before = "") const {
    std::vector<std::string> arguments{in(), out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProcess(SEGMENT_BAG, arguments, before);
  }

  // Every frame has come, in order, with one plane at this distance.
  void expectWalls(const ToolResult& result, int frames, const std::string& planes = kPlanes,
                   double distance = 1.5) const {
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto messages = readAll<PlaneArray>(out());
    ASSERT_EQ(messages.count(planes), 1U) << result.out;
    const auto& arrays = messages.at(planes);
    ASSERT_EQ(arrays.size(), static_cast<std::size_t>(frames)) << result.out;
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      ASSERT_EQ(arrays[i]->planes.size(), 1U) << i;
      EXPECT_NEAR(arrays[i]->planes[0].coefficients.coef[3], distance, 0.002 * distance);
      if (i > 0) {
        EXPECT_LT(arrays[i - 1]->header.stamp, arrays[i]->header.stamp);
      }
    }
  }

  void expectRefused(const ToolResult& result, const std::vector<std::string>& words) const {
    for (const std::string& word : words) expectRefusal(result, "segment_bag", word);
    EXPECT_FALSE(std::filesystem::exists(out()));
  }

  // Images with what `writeInfo(bag, i)` adds to each.
  template <typename WriteInfo>
  void writeBag(WriteInfo&& writeInfo, const std::string& image_topic = kDepth,
                const std::string& encoding = "16UC1") const {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    for (int i = 0; i < kFrames; ++i) {
      sensor_msgs::Image image = wallImage(i);
      image.encoding = encoding;
      bag.write(image_topic, recordingTime(i), image);
      writeInfo(bag, i);
    }
    bag.close();
  }

  static auto writeNoInfo() {
    return [](rosbag::Bag&, int) {};
  }

  static auto writeInfoOn(const std::string& topic) {
    return [topic](rosbag::Bag& bag, int i) { bag.write(topic, recordingTime(i), wallInfo(i)); };
  }

  TemporaryFolder folder_;
};

}  // namespace line_plane_segmentation
