// SPDX-License-Identifier: BSD-3-Clause
// segment_depth: formats and sizes of images, provenance, shards.
#include <climits>
#include <cstdlib>
#include <limits>

#include "segment_depth_fixture.h"

namespace line_plane_segmentation {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

TEST_F(SegmentDepth, RefusesAnImageThatClaimsToBeHugeBeforeItTakesMemory) {
  const std::string png = textOf(writeImage("wall.png", wall()));
  const std::string huge = folder_.write("huge.png", withSize(png, 30000, 30000)).string();
  const std::vector<std::string> arguments{
      "--camera", "525,525,320,240", "--units-per-metre", "5000", "--out", out(), huge};
  // 30000 x 30000 pixels of 16 bits are 1.8 GB.
  expectRefused(runProcess(SEGMENT_DEPTH, arguments, "ulimit -v 1500000;"),
                "huge.png: has 30000 x 30000 pixels");
  expectRefused(segment({(folder_ / "wall.png").string(), "--max-pixels", "300000"}),
                "640 x 480 pixels, too many");
  EXPECT_EQ(segment({(folder_ / "wall.png").string(), "--max-pixels", "307200"}).exit_code, 0);
}

TEST_F(SegmentDepth, FindsDamagedPixelsAndKeepsEarlierResults) {
  const std::string good = writeImage("a.png", wall());
  std::string damaged = textOf(good);
  for (std::size_t i = 60; i < damaged.size() - 20; ++i) damaged[i] = '\x55';
  const ToolResult result = segment({good, folder_.write("b.png", damaged).string(), "--jobs", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("b.png: cannot be read"), std::string::npos) << result.err;
  EXPECT_TRUE(namesIn(out()).empty() || namesIn(out()).size() == 3U);
}

TEST_F(SegmentDepth, ReadsOtherFormats) {
  cv::Mat metres;
  wall().convertTo(metres, CV_32F, 1.0 / 5000.0);
  metres.colRange(0, 5).setTo(std::numeric_limits<float>::quiet_NaN());
  const auto expect_wall = [&](const std::string& image, const std::string& units) {
    SCOPED_TRACE(image);
    const ToolResult result =
        run({"--camera", "525,525,319.5,239.5", "--units-per-metre", units, "--out", out(), image});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json planes = json::parse(
        textOf(out() + "/" + std::filesystem::path(image).stem().string() + ".planes.json"))["planes"];
    ASSERT_EQ(planes.size(), 1U);
    EXPECT_NEAR(planes[0]["d"].get<double>(), 2.0, 0.001);
  };
  const auto npy = [&](const std::string& name, const std::string& type, const cv::Mat& image) {
    std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (480, 640), }";
    header.resize(117, ' ');
    const std::string start("\x93NUMPY\x01\x00\x76\x00", 10);
    return folder_
        .write(name,
               start + header + "\n" +
                   std::string(reinterpret_cast<const char*>(image.data), image.total() * image.elemSize()))
        .string();
  };
  cv::Mat doubles;
  metres.convertTo(doubles, CV_64F);
  expect_wall(writeImage("a16.tiff", wall()), "5000");
  expect_wall(writeImage("a32.tiff", metres), "1");
  expect_wall(writeImage("b16.pgm", wall()), "5000");
  expect_wall(npy("u2.npy", "<u2", wall()), "5000");
  expect_wall(npy("f4.npy", "<f4", metres), "1");
  expect_wall(npy("f8.npy", "<f8", doubles), "1");
  setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 1);
  expect_wall(writeImage("c32.exr", metres), "1");

  std::filesystem::remove_all(out());
  expectRefused(segment({npy("wide.npy", "<u4", wall())}), "wide.npy: holds numbers of type '<u4'");
  expectRefused(segment({folder_.write("cut.npy", textOf(folder_ / "f4.npy").substr(0, 1000)).string()}),
                "is cut off");
  expectRefused(segment({folder_.write("short.npy", "\x93NUMPY").string()}), "cut off in its header");
  for (const char* huge : {"a16.tiff", "c32.exr", "b16.pgm", "f4.npy"}) {
    expectRefused(segment({(folder_ / huge).string(), "--max-pixels", "1000"}), "640 x 480 pixels, too many");
  }
}

TEST_F(SegmentDepth, RecordsWhatTheResultsWereMadeFrom) {
  const std::string image = writeImage("wall.png", wall());
  ASSERT_EQ(segment({image, "--set", "min_range=0.7"}).exit_code, 0);
  const json document = json::parse(textOf(out() + "/wall.planes.json"));
  EXPECT_EQ(document["input"]["path"], std::filesystem::canonical(image).string());
  EXPECT_EQ(document["input"]["bytes"], std::filesystem::file_size(image));
  const ToolResult sum = runProcess("/usr/bin/sha256sum", {image});
  EXPECT_EQ(document["input"]["sha256"], sum.out.substr(0, 64));
  EXPECT_NEAR(document["settings"]["parameters"]["min_range"].get<double>(), 0.7, 1e-6);
  EXPECT_EQ(document["settings"]["depth_unit"], 0.0002);
  EXPECT_EQ(document["settings"]["units_per_metre"], 5000);  // for readers of the older name
  EXPECT_FALSE(document["settings"]["version"].get<std::string>().empty());
}

TEST_F(SegmentDepth, SplitsItsWorkIntoShards) {
  std::vector<std::string> images;
  for (const char* name : {"a.png", "b.png", "c.png", "d.png", "e.png"})
    images.push_back(writeImage(name, wall()));
  const auto shard = [&](const std::string& which) {
    std::vector<std::string> arguments = images;
    arguments.insert(arguments.end(), {"--shard", which});
    return segment(arguments);
  };
  ASSERT_EQ(shard("2/3").exit_code, 0);
  EXPECT_EQ(namesIn(out()), (Names{"b.labels.png", "b.overlay.png", "b.planes.json", "e.labels.png",
                                   "e.overlay.png", "e.planes.json"}));
  ASSERT_EQ(shard("1/3").exit_code, 0);
  ASSERT_EQ(shard("3/3").exit_code, 0);
  EXPECT_EQ(namesIn(out()).size(), 15U);
  const ToolResult more = shard("7/7");
  EXPECT_EQ(more.exit_code, 0) << more.err;
  std::filesystem::remove_all(out());
  for (const char* wrong : {"0/3", "4/3", "1", "1/3x", "a/b", "-1/3"})
    expectRefused(shard(wrong), "--shard takes I/N");
}

TEST_F(SegmentDepth, AcceptsAllNamesOfTheDepthUnit) {
  const std::string image = writeImage("wall.png", wall());
  const std::vector<std::string> rest{"--camera", "525,525,320,240", "--out", out(), image};
  const auto with = [&](std::vector<std::string> units) {
    units.insert(units.end(), rest.begin(), rest.end());
    return run(units);
  };
  expectRefused(with({"--units-per-metre", "5000", "--depth-scale", "5000"}), "are the same");
  expectRefused(with({"--depth-unit", "0.0002", "--depth-scale", "5000"}), "are the same");
  ASSERT_EQ(with({"--depth-unit", "0.0002"}).exit_code, 0);
  EXPECT_NE(with({"--units-per-metre", "5000"}).out.find("finished before"), std::string::npos);
  EXPECT_NE(with({"--depth-scale", "5000"}).out.find("finished before"), std::string::npos);
}

TEST_F(SegmentDepth, TellsWhenStandardOutputIsFull) {
  const std::string image = writeImage("wall.png", wall());
  const std::string command = std::string("'") + SEGMENT_DEPTH +
                              "' --camera 525,525,320,240 --units-per-metre 5000 --out '" + out() + "' '" +
                              image + "' >/dev/full";
  const ToolResult result = runProcess("/bin/sh", {"-c", command});
  expectRefusal(result, "segment_depth", "standard output cannot be written");
  EXPECT_EQ(namesIn(out()).size(), 3U);
}

TEST_F(SegmentDepth, RefusesNamesThatAreTooLongForResults) {
  const std::string name(NAME_MAX - 8, 'x');
  expectRefused(segment({writeImage("a.png", wall()), writeImage(name + ".png", wall())}), "is too long");
}

}  // namespace
}  // namespace line_plane_segmentation
