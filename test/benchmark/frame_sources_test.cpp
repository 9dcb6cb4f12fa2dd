// SPDX-License-Identifier: BSD-3-Clause
#include "frame_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "line_plane_segmentation/plane_segmenter.h"
#include "run_tool.h"
#include "tools/temporary_folder.h"

namespace line_plane_segmentation {
namespace {

TEST(Halved, TakesEverySecondPixelAndKeepsItsRay) {
  BenchmarkFrame frame{"f", 4, 4, {500.0, 510.0, 1.5, 2.5}, 0.001F, {}};
  for (std::uint16_t i = 0; i < 16; ++i) frame.depth.push_back(i);
  const BenchmarkFrame half = halved(frame);
  ASSERT_EQ(half.width, 2);
  ASSERT_EQ(half.height, 2);
  EXPECT_EQ(half.depth, (std::vector<std::uint16_t>{0, 2, 8, 10}));
  EXPECT_DOUBLE_EQ((1 - half.camera.cx) / half.camera.fx, (2 - frame.camera.cx) / frame.camera.fx);
  EXPECT_DOUBLE_EQ((1 - half.camera.cy) / half.camera.fy, (2 - frame.camera.cy) / frame.camera.fy);
}

TEST(SimulatedTiles, EveryTileIsFound) {
  for (const int planes : {1, 2, 5, 10, 20}) {
    const BenchmarkFrame frame = simulatedTiles(planes, 640, 480);
    PlaneSegmenter segmenter;
    EXPECT_EQ(segmenter.segment(frame.view(), frame.camera).planes.size(), static_cast<std::size_t>(planes));
  }
}

TEST(SimulatedTiles, BallsAreNoPlanes) {
  const BenchmarkFrame frame = simulatedTiles(0, 640, 480);
  const auto seen = std::count_if(frame.depth.begin(), frame.depth.end(), [](auto z) { return z != 0; });
  EXPECT_GT(seen, 640 * 480 / 4);
  PlaneSegmenter segmenter;
  EXPECT_TRUE(segmenter.segment(frame.view(), frame.camera).planes.empty());
}

TEST(SimulatedRooms, AreTheSameEachTimeAndDiffer) {
  const auto rooms = simulatedRooms(2, 160, 120);
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_EQ(rooms[0].depth, simulatedRooms(1, 160, 120)[0].depth);
  EXPECT_NE(rooms[0].depth, rooms[1].depth);
}

TEST(RecordedFrames, ReadsWhatTheTableLists) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "depth");
  cv::Mat image(2, 3, CV_16UC1, cv::Scalar(5000));
  image.at<std::uint16_t>(1, 2) = 10000;
  cv::imwrite((folder / "depth/wall.png").string(), image);
  folder.write("frames.csv", "frame,width,height,units_per_metre,fx,fy,cx,cy\nwall,3,2,5000,525,526,1,0.5\n");

  const auto frames = recordedFrames(folder.path());
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].name, "wall");
  EXPECT_EQ(frames[0].depth, (std::vector<std::uint16_t>{5000, 5000, 5000, 5000, 5000, 10000}));
  EXPECT_FLOAT_EQ(frames[0].depth_unit, 0.0002F);
  EXPECT_DOUBLE_EQ(frames[0].camera.fy, 526.0);
}

TEST(RecordedFrames, RefusesAFolderWithoutTable) {
  const TemporaryFolder folder;
  EXPECT_THROW(recordedFrames(folder.path()), BadInput);
}

}  // namespace
}  // namespace line_plane_segmentation
