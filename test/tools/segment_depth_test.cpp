// SPDX-License-Identifier: BSD-3-Clause
#include "segment_depth_fixture.h"

namespace line_plane_segmentation {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

TEST_F(SegmentDepth, SaysThatTheDepthScaleIsWrong) {
  const std::string image = writeImage("wall.png", wall());
  EXPECT_EQ(run({"--camera", "525,525,319.5,239.5", "--units-per-metre", "5000", "--out", out(), image}).err,
            "");
  for (const char* scale : {"5", "500000"}) {
    const ToolResult result =
        run({"--camera", "525,525,319.5,239.5", "--depth-scale", scale, "--out", out(), image});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(
        result.err,
        "segment_depth: in 1 of 1 images most depths lie outside of min_range to max_range: is the depth "
        "unit right?\n");
  }
}

TEST_F(SegmentDepth, WritesLabelsPlanesAndOverlay) {
  const ToolResult result = segment({writeImage("wall.png", wall())});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.rfind("wall: 1 planes", 0), 0U) << result.out;
  EXPECT_EQ(namesIn(out()), (Names{"wall.labels.png", "wall.overlay.png", "wall.planes.json"}));

  const cv::Mat labels = cv::imread(out() + "/wall.labels.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.type(), CV_16UC1);
  ASSERT_EQ(labels.size(), cv::Size(640, 480));
  EXPECT_EQ(labels.at<std::uint16_t>(240, 320), 1);
  EXPECT_EQ(labels.at<std::uint16_t>(240, 620), 0);

  const cv::Mat overlay = cv::imread(out() + "/wall.overlay.png", cv::IMREAD_UNCHANGED);
  EXPECT_EQ(overlay.type(), CV_8UC3);
  EXPECT_EQ(overlay.size(), cv::Size(640, 480));

  const json document = json::parse(textOf(out() + "/wall.planes.json"));
  EXPECT_EQ(document["frame"], "wall");
  ASSERT_EQ(document["planes"].size(), 1U);
  const json& plane = document["planes"][0];
  EXPECT_EQ(plane["label"], 1);
  EXPECT_NEAR(plane["d"].get<double>(), 2.0, 0.001);
  EXPECT_NEAR(plane["normal"][2].get<double>(), -1.0, 1e-4);
  EXPECT_EQ(plane["inliers"], cv::countNonZero(labels == 1));
  const double pixel_area = 2.0 / 525.0 * 2.0 / 525.0;
  EXPECT_NEAR(plane["area"].get<double>(), plane["inliers"].get<double>() * pixel_area, 0.05);
  EXPECT_GT(document["milliseconds"]["total"].get<double>(), 0.0);
}

TEST_F(SegmentDepth, GivesTheSameEveryTime) {
  const std::string image = writeImage("wall.png", wall());
  ASSERT_EQ(segment({image}).exit_code, 0);
  const std::string labels = textOf(out() + "/wall.labels.png");
  const std::string overlay = textOf(out() + "/wall.overlay.png");
  const json planes = json::parse(textOf(out() + "/wall.planes.json"))["planes"];
  ASSERT_EQ(segment({image, "--redo"}).exit_code, 0);
  EXPECT_EQ(textOf(out() + "/wall.labels.png"), labels);
  EXPECT_EQ(textOf(out() + "/wall.overlay.png"), overlay);
  EXPECT_EQ(json::parse(textOf(out() + "/wall.planes.json"))["planes"].dump(), planes.dump());
}

TEST_F(SegmentDepth, TakesManyImagesAndAnImageWithoutAnyDepth) {
  const ToolResult result =
      segment({writeImage("a.png", wall()), writeImage("b.png", cv::Mat::zeros(48, 64, CV_16UC1))});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(namesIn(out()).size(), 6U);
  EXPECT_EQ(json::parse(textOf(out() + "/b.planes.json"))["planes"], json::array());
}

TEST_F(SegmentDepth, HeedsPresetAndParameters) {
  const std::string image = writeImage("wall.png", wall());
  ASSERT_EQ(
      segment({image, "--preset", "paper", "--set", "max_range=1.5", "--set", "min_range=0.5"}).exit_code, 0);
  EXPECT_EQ(json::parse(textOf(out() + "/wall.planes.json"))["planes"], json::array());
}

TEST_F(SegmentDepth, TakesATableOfFrames) {
  writeImage("set/depth/wall.png", wall());
  const std::string table = (folder_ / "set/frames.csv").string();
  folder_.write("set/frames.csv",
                "frame,width,height,units_per_metre,fx,fy,cx,cy\nwall,640,480,5000,525,525,319.5,239.5\n");
  const ToolResult result = run({"--frames-csv", table, "--out", out()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json plane = json::parse(textOf(out() + "/wall.planes.json"))["planes"].at(0);
  EXPECT_NEAR(plane["d"].get<double>(), 2.0, 0.001);

  std::filesystem::remove_all(out());
  expectRefused(run({"--frames-csv", table, "--camera", "525,525,320,240", "--out", out()}),
                "one or the other");
}

TEST_F(SegmentDepth, ExplainsItself) {
  const ToolResult result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  for (const char* word : {"--camera", "--depth-unit", "--units-per-metre", "--depth-scale", "--shard",
                           "rosrun line_plane_segmentation", "--out", "--preset", "--set", "--redo",
                           "--report", "--dataset", "plane_distance"}) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word;
  }
}

TEST_F(SegmentDepth, RefusesAFileThatIsNoDepthImage) {
  const std::string good = writeImage("good.png", wall());
  const auto expect_bad = [&](const std::string& bad, const std::string& reason) {
    SCOPED_TRACE(bad);
    expectRefused(segment({good, bad}), reason);
  };
  expect_bad((folder_ / "missing.png").string(), "missing.png: no such file");
  expect_bad(folder_.path().string(), "is not a file");
  expect_bad(writeImage("grey.png", cv::Mat(48, 64, CV_8UC1, cv::Scalar(7))), "grey.png: has 8 bits");
  expect_bad(writeImage("color.png", cv::Mat(48, 64, CV_8UC3, cv::Scalar(7))), "color.png: has 3 channels");
  expect_bad(writeImage("color16.png", cv::Mat(48, 64, CV_16UC3, cv::Scalar(7))),
             "color16.png: has 3 channels");
  expect_bad(folder_.write("empty.png", "").string(), "empty.png: cannot be read");
  expect_bad(folder_.write("text.png", "this is no picture\n").string(), "text.png: cannot be read");
  const std::string whole = textOf(good);
  expect_bad(folder_.write("cut.png", whole.substr(0, whole.size() / 2)).string(), "cut.png: cannot be read");
  expect_bad(folder_.write("no_width.png", withSize(whole, 0, 480)).string(), "no_width.png: cannot be read");
}

TEST_F(SegmentDepth, RefusesWrongOptions) {
  const std::string image = writeImage("wall.png", wall());
  expectRefused(segment({}), "no image");
  expectRefused(segment({image, "--preset", "lidar"}), "no preset is named 'lidar'");
  expectRefused(segment({image, "--set", "speed=9"}), "speed");
  expectRefused(segment({image, "--set", "line_fidelity=2"}),
                "line_fidelity has no effect on the method adaptive");
  expectRefused(segment({image, "--set", "plane_distance"}), "PARAMETER=VALUE");
  expectRefused(segment({image, "--set", "plane_distance=thin"}), "thin");
  expectRefused(segment({image, "--set", "plane_distance=9"}), "plane_distance");
  expectRefused(segment({image, "--set", "min_range=5", "--set", "max_range=4"}), "min_range");
  expectRefused(segment({image, "--colour"}), "--colour");
  expectRefused(run({"--camera", "525,525,320", "--depth-scale", "1000", "--out", out(), image}),
                "FX,FY,CX,CY");
  expectRefused(run({"--camera", "525,525,320,240", "--depth-scale", "0", "--out", out(), image}),
                "depth unit");
  expectRefused(run({"--camera", "525,525,320,240", "--depth-scale", "many", "--out", out(), image}), "many");
  expectRefused(run({"--depth-scale", "1000", "--out", out(), image}), "--camera is missing");
  expectRefused(run({"--camera", "525,525,320,240", "--out", out(), image}), "--depth-unit is missing");
  expectRefused(run({"--camera", "525,525,320,240", "--depth-scale", "1000", image}), "--out is missing");
}

TEST_F(SegmentDepth, RefusesResultsThatWouldOverwriteEachOtherOrTheInput) {
  expectRefused(segment({writeImage("x/wall.png", wall()), writeImage("y/wall.png", wall())}),
                "two images are named 'wall'");

  const std::string image = writeImage("z/wall.png", wall());
  const std::string labels = writeImage("z/wall.labels.png", wall());
  const std::string before = textOf(labels);
  expectRefusal(run({"--camera", "525,525,320,240", "--depth-scale", "1000", "--out",
                     (folder_ / "z").string(), image, labels}),
                "segment_depth", "would be overwritten");
  EXPECT_EQ(textOf(labels), before);
}

TEST_F(SegmentDepth, RefusesAnOutputFolderThatCannotBe) {
  const std::string image = writeImage("wall.png", wall());
  folder_.write("file", "");
  for (const char* where : {"file", "file/below"}) {
    expectRefusal(run({"--camera", "525,525,320,240", "--depth-scale", "1000", "--out",
                       (folder_ / where).string(), image}),
                  "segment_depth", "cannot make this folder");
  }
}

TEST_F(SegmentDepth, LeavesNothingHalfWrittenWhenItCannotWriteOn) {
  const std::string image = writeImage("wall.png", wall());
  const ToolResult result = runProcess(
      SEGMENT_DEPTH, {"--camera", "525,525,320,240", "--depth-scale", "1000", "--out", out(), image},
      "trap '' XFSZ; ulimit -f 2;");
  expectRefusal(result, "segment_depth", "cannot be written");
  EXPECT_EQ(namesIn(out()), Names{});
}

}  // namespace
}  // namespace line_plane_segmentation
