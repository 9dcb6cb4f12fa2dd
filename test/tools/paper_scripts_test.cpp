// SPDX-License-Identifier: BSD-3-Clause
// scripts/get_tum from a mirror, and scripts/reproduce_paper on what it fetched.
#include <gtest/gtest.h>

#include <sched.h>

#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "temporary_folder.h"
#include "tool_process.h"

namespace line_plane_segmentation {
namespace {

using Names = std::vector<std::string>;
const Names kSequences{"freiburg1_desk", "freiburg3_cabinet", "freiburg1_360", "freiburg3_sitting_static"};

class PaperScripts : public testing::Test {
 protected:
  PaperScripts() {
    for (const std::string& sequence : kSequences) makeArchive(sequence);
  }

  std::string mirror() const { return (folder_ / "mirror").string(); }
  std::string data() const { return (folder_ / "data").string(); }
  std::filesystem::path archive(const std::string& sequence) const {
    return folder_ / ("mirror/" + sequence.substr(0, 9) + "/rgbd_dataset_" + sequence + ".tgz");
  }
  std::filesystem::path depth(const std::string& sequence) const {
    return folder_ / ("data/rgbd_dataset_" + sequence + "/depth");
  }

  // As TUM's: colour beside depth. The picture is a small wall before nothing, so that the slow methods are
  // not slow.
  void makeArchive(const std::string& sequence) const {
    const std::filesystem::path source = folder_ / ("source/rgbd_dataset_" + sequence);
    std::filesystem::create_directories(source / "depth");
    std::filesystem::create_directories(source / "rgb");
    cv::Mat image = cv::Mat::zeros(480, 640, CV_16UC1);
    image(cv::Rect(200, 150, 160, 120)).setTo(7500);
    cv::imwrite((source / "depth/100.5.png").string(), image);
    cv::imwrite((source / "depth/101.5.png").string(), image);
    cv::imwrite((source / "rgb/100.4.png").string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(1, 2, 3)));
    for (const char* text : {"depth.txt", "groundtruth.txt", "rgb.txt"}) {
      folder_.write("source/rgbd_dataset_" + sequence + "/" + text, "# times\n");
    }
    std::filesystem::create_directories(archive(sequence).parent_path());
    const std::string command = "tar -czf '" + archive(sequence).string() + "' -C '" +
                                (folder_ / "source").string() + "' 'rgbd_dataset_" + sequence + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
  }

  ToolResult getTum(const std::string& from, const std::vector<std::string>& sequences = {}) const {
    std::vector<std::string> arguments{"--mirror", from, data()};
    arguments.insert(arguments.end(), sequences.begin(), sequences.end());
    return runProcess(GET_TUM, arguments);
  }

  void expectNothingBehind() const {
    EXPECT_EQ(namesIn(data()), Names{}) << "something half-done was left behind";
  }

  TemporaryFolder folder_;
};

TEST_F(PaperScripts, GetTumTakesFromAFolder) {
  const ToolResult result = getTum(mirror());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const std::string& sequence : kSequences) {
    EXPECT_EQ(namesIn(depth(sequence)), (Names{"100.5.png", "101.5.png"}));
    EXPECT_EQ(namesIn(depth(sequence).parent_path()), (Names{"depth", "depth.txt", "groundtruth.txt"}));
    EXPECT_NE(result.out.find("rgbd_dataset_" + sequence + ": 2 depth images"), std::string::npos)
        << result.out;
  }
  EXPECT_EQ(namesIn(data()).size(), 4U);

  // What is there is not asked for again.
  std::filesystem::remove_all(mirror());
  EXPECT_EQ(getTum(mirror()).exit_code, 0);
}

TEST_F(PaperScripts, GetTumTakesFromAnAddress) {
  const ToolResult result = getTum("file://" + mirror(), {"freiburg1_desk"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("Loading 1 MB from file://"), std::string::npos) << result.out;
  EXPECT_EQ(namesIn(depth("freiburg1_desk")).size(), 2U);
  EXPECT_EQ(namesIn(data()).size(), 1U);
}

TEST_F(PaperScripts, GetTumComparesChecksums) {
  const std::string name = "rgbd_dataset_freiburg1_desk.tgz";
  const std::string sum =
      runProcess("/usr/bin/sha256sum", {archive("freiburg1_desk").string()}).out.substr(0, 64);
  const auto with = [&](const std::string& line) {
    const std::string list = folder_.write("sums", line).string();
    return runProcess(GET_TUM, {"--mirror", mirror(), "--checksums", list, data(), "freiburg1_desk"});
  };
  expectRefusal(with(std::string(64, '0') + "  " + name + "\n"), "get_tum", "damaged or replaced");
  expectRefusal(with(sum + "  other.tgz\n"), "get_tum", "its checksum is not in");
  folder_.write("mirror/SHA256SUMS", std::string(64, '1') + "  ./freiburg1/" + name + "\n");
  for (const std::string& from : {mirror(), "file://" + mirror()}) {
    EXPECT_NE(getTum(from, {"freiburg1_desk"}).err.find("damaged or replaced"), std::string::npos) << from;
  }
  expectNothingBehind();
  const ToolResult good = with(sum + " *" + name + "\n");
  ASSERT_EQ(good.exit_code, 0) << good.err;
  EXPECT_NE(good.out.find(sum + "  " + name), std::string::npos) << good.out;
}

TEST(LastProcessor, IsTheLastOneAllowed) {
  const std::string script = std::string("source '") + SCRIPTS +
                             "/environment.sh'; last_processor; taskset -c 0 bash -c "
                             "\"source '" +
                             SCRIPTS + "/environment.sh'; last_processor\"";
  cpu_set_t allowed;
  ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
  int last = 0;
  for (int i = 0; i < CPU_SETSIZE; ++i) last = CPU_ISSET(i, &allowed) ? i : last;
  const ToolResult result = runProcess("/bin/bash", {"-c", script}, "export OMP_NUM_THREADS=1;");
  EXPECT_EQ(result.out, std::to_string(last) + "\n0\n") << result.err;
}

TEST_F(PaperScripts, GetTumTakesUnencryptedAddressesOnlyIfAsked) {
  const std::string from = "http://127.0.0.1:9/tum";
  expectRefusal(getTum(from), "get_tum", "is not encrypted: use https://, or --allow-http");
  expectRefusal(runProcess(GET_TUM, {"--mirror", from, "--allow-http", data()}), "get_tum",
                "cannot be reached");
}

TEST_F(PaperScripts, GetTumTellsWhatIsWrong) {
  expectRefusal(getTum(mirror(), {"freiburg2_moon"}), "get_tum", "has no rgbd_dataset_freiburg2_moon.tgz");
  expectNothingBehind();
  expectRefusal(getTum("file://" + mirror(), {"freiburg2_moon"}), "get_tum",
                "has no rgbd_dataset_freiburg2_moon.tgz");
  expectNothingBehind();
  std::filesystem::resize_file(archive("freiburg1_desk"),
                               std::filesystem::file_size(archive("freiburg1_desk")) / 2);
  expectRefusal(getTum(mirror(), {"freiburg1_desk"}), "get_tum",
                "rgbd_dataset_freiburg1_desk.tgz: is broken or incomplete");
  expectNothingBehind();
}

TEST_F(PaperScripts, ReproducePaperMakesTablesAndPictures) {
  ASSERT_EQ(getTum(mirror()).exit_code, 0);
  const std::string out = (folder_ / "paper").string();
  const ToolResult result = runProcess(
      REPRODUCE_PAPER, {"--tum", data(), "--out", out, "--repetitions", "1", "--programs", PROGRAMS});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string tables = textOf(out + "/paper.md");
  EXPECT_EQ(result.out.rfind(tables, 0), 0U);
  for (const char* words :
       {"| | tabletop | floor | corner | complex |", "### Table 1", "### Table 2", "### Table 3",
        "### Table 4", "| RANSAC | 626 / ", "| line extraction | 19 / ", "| QVGA | 30.7 / ",
        "| 5 points | 365 / ", "| paper_1 | 1 | 1 | 1 | 1 |", "| rgs | 1 | 1 | 1 | 1 |"}) {
    EXPECT_NE(tables.find(words), std::string::npos) << words << " in:\n" << tables;
  }
  const cv::Mat sheet = cv::imread(out + "/figure5.png");
  EXPECT_GE(sheet.rows, 4 * 240);
  EXPECT_GE(sheet.cols, 8 * 320);
  for (const char* picture : {"tabletop.paper_1", "floor.rgs", "corner.ransac", "complex.omps"}) {
    const cv::Mat image = cv::imread(out + "/" + picture + ".png");
    EXPECT_EQ(image.size(), cv::Size(640, 480)) << picture;
  }
  // The wall in the first plane's colour, unlike the grey of what is no plane.
  const auto pixel = cv::imread(out + "/tabletop.paper_1.png").at<cv::Vec3b>(200, 280);
  EXPECT_GT(pixel[2], pixel[0] + 40);
}

TEST_F(PaperScripts, ReproducePaperTellsWhatIsWrong) {
  expectRefusal(runProcess(REPRODUCE_PAPER,
                           {"--tum", data(), "--out", (folder_ / "o").string(), "--programs", PROGRAMS}),
                "reproduce_paper", "scripts/get_tum");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "o"));
  expectRefusal(runProcess(REPRODUCE_PAPER, {"--frames", data(), "--programs", PROGRAMS}), "reproduce_paper",
                "frames.csv; give --frames DIR, or --tum DIR");
}

}  // namespace
}  // namespace line_plane_segmentation
