// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <boost/algorithm/string.hpp>

#include "temporary_folder.h"
#include "test_bag.h"
#include "tool_process.h"

namespace line_plane_segmentation {
namespace {

using Counts = std::map<std::string, int>;
using Names = std::vector<std::string>;
constexpr char kDepth[] = "/camera/depth/image_raw";
constexpr char kPlanes[] = "/camera/plane_segmenter/planes";

class SegmentBag : public testing::Test {
 protected:
  std::string in() const { return (folder_ / "in.bag").string(); }
  std::string out() const { return (folder_ / "out.bag").string(); }

  ToolResult run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{in(), out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProcess(SEGMENT_BAG, arguments);
  }

  void expectRefused(const ToolResult& result, const std::string& reason) const {
    expectRefusal(result, "segment_bag", reason);
    EXPECT_FALSE(std::filesystem::exists(out()));
    for (const std::string& name : namesIn(folder_.path()))
      EXPECT_NE(name.front(), '.') << name << " was left behind";
  }

  // The planes of OUT.bag without what the clock had a part in.
  std::vector<std::string> planes() const {
    std::vector<std::string> all;
    const auto messages = readAll<PlaneArray>(out());
    for (const auto& message : messages.at(kPlanes)) {
      message->processing_time = 0.0F;
      message->processing_seconds = 0.0;
      all.push_back(bytesOf(*message));
    }
    return all;
  }

  TemporaryFolder folder_;
};

TEST_F(SegmentBag, AnswersEachImageWithItsStamp) {
  writeWallBag(in(), 5);
  const ToolResult result = run();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, std::string(kDepth) + " -> /camera/plane_segmenter: 5 frames, 5 planes\n");
  EXPECT_EQ(countTopics(out()), (Counts{{kPlanes, 5}}));
  EXPECT_EQ(namesIn(folder_.path()), (Names{"in.bag", "out.bag"}));

  const rosbag::Bag bag(out());
  int i = 0;
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    EXPECT_EQ(message.getTime(), recordingTime(i));
    const auto planes = message.instantiate<PlaneArray>();
    EXPECT_EQ(planes->header.stamp, stampOf(i));
    EXPECT_EQ(planes->header.frame_id, kBagFrame);
    ASSERT_EQ(planes->planes.size(), 1U);
    EXPECT_NEAR(planes->planes[0].coefficients.coef[3], 1.5, 0.002);
    EXPECT_GE(planes->planes[0].outline.points.size(), 4U);
    ++i;
  }
}

// The first transform comes after the first image.
TEST_F(SegmentBag, ReadsOnForTransformsThatComeLater) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    for (int i = 0; i < 3; ++i) {
      bag.write(kDepth, recordingTime(i), wallImage(i));
      bag.write("/camera/depth/camera_info", recordingTime(i), wallInfo(i));
      bag.write("/tf", recordingTime(i) + ros::Duration(0.02), placeInWorld(i));
    }
  }
  ASSERT_EQ(run({"--set", "target_frame=world"}).exit_code, 0);
  const auto messages = readAll<PlaneArray>(out());
  ASSERT_EQ(messages.at(kPlanes).size(), 3U);
  for (const auto& planes : messages.at(kPlanes)) EXPECT_EQ(planes->header.frame_id, "world");
}

TEST_F(SegmentBag, WritesOnRequestAllThatTheNodeletPublishesAndTheInput) {
  writeWallBag(in(), 2);
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Append);
    std_msgs::String text;
    text.data = "kept";
    bag.write("/notes", recordingTime(7), text);
    bag.close();
  }
  ASSERT_EQ(run({"--all"}).exit_code, 0);
  EXPECT_EQ(countTopics(out()), (Counts{{kDepth, 2},
                                        {"/camera/depth/camera_info", 2},
                                        {"/camera/plane_segmenter/cloud", 2},
                                        {"/camera/plane_segmenter/labels", 2},
                                        {"/camera/plane_segmenter/markers", 2},
                                        {"/camera/plane_segmenter/overlay", 2},
                                        {kPlanes, 2},
                                        {"/camera/plane_segmenter/scanlines", 2},
                                        {"/notes", 1}}));
  const auto images = readAll<sensor_msgs::Image>(out());
  EXPECT_EQ(bytesOf(*images.at(kDepth)[1]), bytesOf(wallImage(1)));
  const sensor_msgs::Image& labels = *images.at("/camera/plane_segmenter/labels")[1];
  EXPECT_EQ(labels.header.stamp, stampOf(1));
  EXPECT_EQ(labels.data.at((60 * kBagWidth + 80) * 2), 1) << "the wall's label";
  EXPECT_EQ(readAll<std_msgs::String>(out()).at("/notes")[0]->data, "kept");
  EXPECT_EQ(readAll<sensor_msgs::PointCloud2>(out()).at("/camera/plane_segmenter/cloud")[0]->width,
            kBagWidth);
}

TEST_F(SegmentBag, TakesEveryDepthTopicOrTheNamedOnes) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    for (int i = 0; i < 3; ++i) {
      // The camera_info comes first, and belongs to both depth topics.
      bag.write("/camera/depth/camera_info", recordingTime(i), wallInfo(i));
      bag.write(kDepth, recordingTime(i), wallImage(i));
      bag.write("/camera/depth/image_rect", recordingTime(i) + ros::Duration(0.001), wallImage(i, 900));
      sensor_msgs::Image other = wallImage(i);
      other.encoding = "mono16";
      bag.write("/camera/ir/camera_info", recordingTime(i), wallInfo(i));
      bag.write("/camera/ir/image", recordingTime(i), other);
    }
    bag.close();
  }
  ASSERT_EQ(run().exit_code, 0);
  EXPECT_EQ(countTopics(out()),
            (Counts{{kPlanes, 3}, {"/camera/depth/image_rect/plane_segmenter/planes", 3}}));
  const auto planes = readAll<PlaneArray>(out());
  EXPECT_NEAR(planes.at(kPlanes)[2]->planes.at(0).coefficients.coef[3], 1.5, 0.002);
  EXPECT_NEAR(
      planes.at("/camera/depth/image_rect/plane_segmenter/planes")[2]->planes.at(0).coefficients.coef[3], 0.9,
      0.002);

  ASSERT_EQ(run({"--topic", "/camera/ir/image"}).exit_code, 0);
  EXPECT_EQ(countTopics(out()), (Counts{{kPlanes, 3}}));
}

TEST_F(SegmentBag, CompressedBagsGiveTheSame) {
  std::vector<std::string> plain;
  for (const auto compression :
       {rosbag::compression::Uncompressed, rosbag::compression::LZ4, rosbag::compression::BZ2}) {
    writeWallBag(in(), 3, compression);
    ASSERT_EQ(run().exit_code, 0);
    if (plain.empty()) plain = planes();
    ASSERT_EQ(plain.size(), 3U);
    EXPECT_EQ(planes(), plain);
  }
  for (const char* compression : {"none", "lz4", "bz2"}) {
    ASSERT_EQ(run({"--compression", compression}).exit_code, 0);
    EXPECT_EQ(planes(), plain) << compression;
  }
}

TEST_F(SegmentBag, WritesATableOfPlanes) {
  writeWallBag(in(), 2);
  const std::string csv = (folder_ / "planes.csv").string();
  ASSERT_EQ(run({"--csv", csv, "--set", "min_plane_inliers=500"}).exit_code, 0);
  std::vector<std::string> lines;
  boost::split(lines, textOf(csv), boost::is_any_of("\n"));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[3], "");
  std::vector<std::string> columns, cells;
  boost::split(columns, lines[0], boost::is_any_of(","));
  boost::split(cells, lines[2], boost::is_any_of(","));
  ASSERT_EQ(columns.size(), cells.size());
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < cells.size(); ++i) row[columns[i]] = cells[i];
  const auto message = readAll<PlaneArray>(out())[kPlanes].at(1);
  const Plane& plane = message->planes.at(0);
  EXPECT_EQ(row["topic"], kDepth);
  EXPECT_EQ(row["stamp"], "1000.100000000");
  EXPECT_EQ(row["id"], std::to_string(plane.id));
  EXPECT_EQ(std::stod(row["nz"]), plane.coefficients.coef[2]);
  EXPECT_EQ(std::stod(row["d"]), plane.coefficients.coef[3]);
  EXPECT_EQ(std::stod(row["centroid_x"]), plane.centroid.x);
  EXPECT_EQ(row["inliers"], std::to_string(plane.inliers));
  EXPECT_EQ(std::stof(row["area"]), plane.area);
  EXPECT_EQ(row["orientation"], "unknown");
}

TEST_F(SegmentBag, HeedsParameters) {
  writeWallBag(in(), 1);
  ASSERT_EQ(run({"--preset", "paper", "--set", "max_range=1.2"}).exit_code, 0);
  EXPECT_EQ(readAll<PlaneArray>(out())[kPlanes].at(0)->planes.size(), 0U);
}

TEST_F(SegmentBag, PassesOverWhatTheNodeletRefuses) {
  {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    for (int i = 0; i < 4; ++i) {
      sensor_msgs::Image image = wallImage(i);
      if (i == 1) image.data.pop_back();
      bag.write(kDepth, recordingTime(i), image);
      if (i != 2) bag.write("/camera/depth/camera_info", recordingTime(i), wallInfo(i));
    }
    bag.close();
  }
  const ToolResult result = run();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("2 frames, 2 planes, 1 images without camera_info, 1 refused: the image holds"),
            std::string::npos)
      << result.out;
}

TEST_F(SegmentBag, ExplainsItself) {
  const ToolResult result = runProcess(SEGMENT_BAG, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* word :
       {"--topic", "--labels", "--cloud", "--overlay", "--markers", "--scanlines", "--input", "--csv",
        "--compression", "--preset", "plane_distance", "gravity_frame", "track_memory"}) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word;
  }
}

TEST_F(SegmentBag, RefusesWhatIsNoBag) {
  expectRefused(run(), "in.bag: no such file");
  folder_.write("in.bag", "");
  expectRefused(run(), "is not a bag");
  folder_.write("in.bag", "these are my words\n");
  expectRefused(run(), "is not a bag");
  std::filesystem::remove(in());
  std::filesystem::create_directory(in());
  expectRefused(run(), "is not a file");
}

TEST_F(SegmentBag, RefusesABagWithoutDepth) {
  const auto write_bag = [this](const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info) {
    rosbag::Bag bag(in(), rosbag::bagmode::Write);
    bag.write(kDepth, recordingTime(0), image);
    bag.write("/camera/depth/camera_info", recordingTime(0), info);
    bag.close();
  };
  sensor_msgs::Image colour = wallImage(0);
  colour.encoding = "rgb8";
  write_bag(colour, wallInfo(0));
  expectRefused(run(), "holds no depth images; its images are /camera/depth/image_raw (rgb8)");
  expectRefused(run({"--topic", kDepth}), "'rgb8' is no depth image");
  write_bag(wallImage(0), wallInfo(5));
  expectRefused(run({"--set", "info_matching=exact"}),
                "none of the 1 images of /camera/depth/image_raw has a camera_info");
  write_bag(wallImage(0), sensor_msgs::CameraInfo());
  expectRefused(run(), "none of the 1 images");
  sensor_msgs::CameraInfo uncalibrated = wallInfo(0);
  uncalibrated.K.fill(0.0);
  uncalibrated.P.fill(0.0);
  write_bag(wallImage(0), uncalibrated);
  expectRefused(run(), "calibrate the camera");
}

TEST_F(SegmentBag, RefusesWrongOptions) {
  writeWallBag(in(), 1);
  expectRefused(runProcess(SEGMENT_BAG, {in()}), "IN.bag and OUT.bag");
  expectRefused(run({"third.bag"}), "IN.bag and OUT.bag");
  expectRefused(run({"--topic", "/nothing"}), "has no topic /nothing");
  expectRefused(run({"--topic", "/camera/depth/camera_info"}), "is sensor_msgs/CameraInfo");
  expectRefused(run({"--compression", "zip"}), "zip");
  expectRefused(run({"--set", "speed=9"}), "speed");
  expectRefused(run({"--set", "track_planes=perhaps"}), "'perhaps' is no value for track_planes");
  expectRefused(run({"--set", "orientation_tolerance=50"}), "orientation_tolerance = 50 is outside 0 to 45");
  expectRefused(run({"--set", "target_frame=moon"}), "planes cannot be given in target_frame");
  expectRefused(run({"--quickly"}), "--quickly");
  expectRefused(run({"--csv", in()}), "would overwrite");
  expectRefused(run({"--csv", out()}), "would overwrite");
  expectRefused(run({"--csv", (folder_ / "missing/planes.csv").string()}),
                "missing/planes.csv: cannot be written");
  expectRefusal(runProcess(SEGMENT_BAG, {in(), in()}), "segment_bag", "would overwrite IN.bag");
  expectRefusal(runProcess(SEGMENT_BAG, {in(), (folder_ / "missing/out.bag").string()}), "segment_bag",
                "missing/out.bag: cannot be written");
  EXPECT_EQ(countTopics(in()).size(), 2U) << "the input was touched";
}

TEST_F(SegmentBag, KeepsTheOldBagAndTableWhenItFails) {
  writeWallBag(in(), 3);
  folder_.write("out.bag", "old");
  folder_.write("planes.csv", "older");
  const ToolResult full =
      runProcess(SEGMENT_BAG, {in(), out(), "--all", "--csv", (folder_ / "planes.csv").string()},
                 "trap '' XFSZ; ulimit -f 40;");
  expectRefusal(full, "segment_bag", "cannot be written");
  EXPECT_EQ(textOf(out()), "old");
  EXPECT_EQ(textOf(folder_ / "planes.csv"), "older");
  EXPECT_EQ(namesIn(folder_.path()), (Names{"in.bag", "out.bag", "planes.csv"}));
}

}  // namespace
}  // namespace line_plane_segmentation
