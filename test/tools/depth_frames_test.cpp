// SPDX-License-Identifier: BSD-3-Clause
#include "depth_frames.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "run_tool.h"
#include "temporary_folder.h"

namespace line_plane_segmentation {
namespace {

TEST(ParseCamera, ReadsFourNumbers) {
  const CameraIntrinsics camera = parseCamera("525.5,5.2e2,-3,239.5");
  EXPECT_EQ(camera.fx, 525.5);
  EXPECT_EQ(camera.fy, 520.0);
  EXPECT_EQ(camera.cx, -3.0);
  EXPECT_EQ(camera.cy, 239.5);
}

class WrongCamera : public testing::TestWithParam<const char*> {};

TEST_P(WrongCamera, IsRefused) { EXPECT_THROW(parseCamera(GetParam()), BadInput); }

INSTANTIATE_TEST_SUITE_P(Texts, WrongCamera,
                         testing::Values("", "525", "525,525,320", "525,525,320,240,1", "525,525,320,",
                                         "a,b,c,d", "525 525 320 240", "525,525,320,240px", "0,525,320,240",
                                         "525,-525,320,240", "nan,525,320,240", "525,525,inf,240",
                                         "525,,320,240"));

TEST(FramesOfImages, AreNamedAfterTheirFiles) {
  const auto frames = framesOfImages({"some/where/b.1.png", "a.png"}, {500, 501, 320, 240}, 0.0002);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].name, "b.1");
  EXPECT_EQ(frames[0].image, "some/where/b.1.png");
  EXPECT_EQ(frames[0].camera.fy, 501);
  EXPECT_EQ(frames[0].depth_unit, 0.0002);
  EXPECT_EQ(frames[1].name, "a");
}

TEST(FramesOfImages, NeedADepthUnit) {
  for (const double unit : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(framesOfImages({"a.png"}, {500, 500, 320, 240}, unit), BadInput) << unit;
  }
}

TEST(CheckNames, RefusesNoneAndTwoOfOneName) {
  EXPECT_THROW(checkNames({}), BadInput);
  EXPECT_THROW(checkNames(framesOfImages({"x/a.png", "y/a.png"}, {500, 500, 320, 240}, 0.001)), BadInput);
  EXPECT_NO_THROW(checkNames(framesOfImages({"x/a.png", "y/b.png"}, {500, 500, 320, 240}, 0.001)));
}

class FramesTable : public testing::Test {
 protected:
  std::vector<DepthFrame> read(const std::string& text) const {
    return framesOfTable(folder_.write("frames.csv", text));
  }

  void expectRefused(const std::string& text, const std::string& reason) const {
    try {
      read(text);
      ADD_FAILURE() << "accepted:\n" << text;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("frames.csv"), std::string::npos) << error.what();
    }
  }

  const std::string header_ = "frame,width,height,units_per_metre,fx,fy,cx,cy,sensor,scene\n";
  TemporaryFolder folder_;
};

TEST_F(FramesTable, GivesAFrameForEachRow) {
  const auto frames = read(header_ + "a,640,480,5000,518.8,519.5,325.5,253.7,\"Kinect, v1\",room\r\n\n" +
                           "b,4,3,1000,525,526,1,2,\"says \"\"x\"\"\",\\back\n");
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].name, "a");
  EXPECT_EQ(frames[0].image, folder_ / "depth/a.png");
  EXPECT_EQ(frames[0].width, 640);
  EXPECT_EQ(frames[0].height, 480);
  EXPECT_EQ(frames[0].depth_unit, 0.0002);
  EXPECT_EQ(frames[0].camera.fx, 518.8);
  EXPECT_EQ(frames[1].camera.fy, 526);
  EXPECT_EQ(frames[1].camera.cx, 1);
  EXPECT_EQ(frames[1].camera.cy, 2);
}

TEST_F(FramesTable, IsReadAsSpreadsheetsWriteIt) {
  const auto frames = read("\xEF\xBB\xBF\"frame\",width,height,units_per_metre,fx,fy,cx,cy,note\r\n" +
                           std::string("\"a \"\"b\"\", c\",640,480,1000,525,525,320,240,\"\"\r\n"));
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].name, "a \"b\", c");
  EXPECT_EQ(frames[0].width, 640);
  expectRefused(header_ + "\"a,640,480,1000,525,525,320,240\n", "line 2: a quote is not closed");
}

TEST_F(FramesTable, TakesAnotherFormatWhereThereIsNoPng) {
  std::filesystem::create_directory(folder_ / "depth");
  const std::string row = "640,480,1000,525,525,320,240,,\n";
  folder_.write("depth/a.npy", "");
  folder_.write("depth/b.npy", "");
  folder_.write("depth/b.png", "");
  const auto frames = read(header_ + "a," + row + "b," + row + "c," + row);
  EXPECT_EQ(frames[0].image.filename(), "a.npy");
  EXPECT_EQ(frames[1].image.filename(), "b.png");
  EXPECT_EQ(frames[2].image.filename(), "c.png");
}

TEST_F(FramesTable, ColumnsGoByName) {
  const auto frames = read("cy,cx,fy,fx,units_per_metre,height,width,frame\n2,1,526,525,1000,3,4,b\n");
  const auto in_metres = read("cy,cx,fy,fx,depth_unit,height,width,frame\n2,1,526,525,0.0002,3,4,b\n");
  EXPECT_EQ(in_metres[0].depth_unit, 0.0002);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].name, "b");
  EXPECT_EQ(frames[0].camera.cx, 1);
  EXPECT_EQ(frames[0].width, 4);
}

TEST_F(FramesTable, TellsWhatIsWrongAndWhere) {
  expectRefused("", "cannot be read");
  expectRefused("frame,width\na,640\n", "line 2: has no column 'fx'");
  const std::string good = "a,640,480,1000,525,525,320,240,,\n";
  expectRefused(header_ + good + "b,640,480,1000,525,wide,320,240,,\n", "line 3: 'wide' is no number");
  expectRefused(header_ + "a,640,480,0,525,525,320,240,,\n", "depth unit");
  expectRefused(header_ + "a,640,480,1000,-525,525,320,240,,\n", "focal lengths");
  expectRefused(header_ + "a,0,480,1000,525,525,320,240,,\n", "'0' is no width");
  expectRefused(header_ + "../a,640,480,1000,525,525,320,240,,\n", "no name of a frame");
  expectRefused(header_ + "a,640\n", "line 2");
}

TEST_F(FramesTable, RefusesAFolderAndAMissingFile) {
  EXPECT_THROW(framesOfTable(folder_.path()), BadInput);
  EXPECT_THROW(framesOfTable(folder_ / "missing.csv"), BadInput);
}

TEST_F(FramesTable, AnImageMustHaveTheSizeThatTheTableSays) {
  std::filesystem::create_directory(folder_ / "depth");
  cv::imwrite((folder_ / "depth/a.png").string(), cv::Mat(3, 4, CV_16UC1, cv::Scalar(1000)));
  const cv::Mat depth = readDepth(read(header_ + "a,4,3,1000,525,525,2,1,,\n").front());
  EXPECT_EQ(depth.size(), cv::Size(4, 3));
  EXPECT_THROW(readDepth(read(header_ + "a,3,4,1000,525,525,2,1,,\n").front()), BadInput);
}

}  // namespace
}  // namespace line_plane_segmentation
