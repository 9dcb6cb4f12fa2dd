// SPDX-License-Identifier: BSD-3-Clause
// segment_depth on folders: a run goes on where another one ended, and a page shows the results.
#include <gtest/gtest.h>

#include <boost/algorithm/string.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "temporary_folder.h"
#include "tool_process.h"

namespace line_plane_segmentation {
namespace {

using Names = std::vector<std::string>;
constexpr char kSequence[] = "rgbd_dataset_freiburg1_wall";

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t times = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++times;
  return times;
}

class SegmentFolder : public testing::Test {
 protected:
  SegmentFolder() {
    std::filesystem::create_directories(folder_ / kSequence / "depth");
    for (int i = 0; i < 5; ++i) writeImage(i);
  }

  void writeImage(int i) const {
    cv::imwrite(image(i), cv::Mat(120, 160, CV_16UC1, cv::Scalar(10000 + 500 * i)));
  }
  std::string image(int i) const {
    return (folder_ / kSequence / "depth" / ("130503145" + std::to_string(i) + ".5.png")).string();
  }
  std::string out() const { return (folder_ / "out").string(); }
  std::string planes(int i) const { return out() + "/130503145" + std::to_string(i) + ".5.planes.json"; }

  ToolResult segment(const std::vector<std::string>& more = {}, const std::string& before = "") const {
    std::vector<std::string> arguments{"--dataset", "tum", "--out", out(), (folder_ / kSequence).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProcess(SEGMENT_DEPTH, arguments, before);
  }

  // The numbers of the images that a run worked on.
  static std::vector<int> workedOn(const ToolResult& result) {
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::vector<int> numbers;
    for (int i = 0; i < 5; ++i) {
      if (result.out.find("130503145" + std::to_string(i) + ".5: 1 planes") != std::string::npos)
        numbers.push_back(i);
    }
    return numbers;
  }

  TemporaryFolder folder_;
};

TEST_F(SegmentFolder, TakesAllOfASequenceInOrder) {
  const ToolResult result = segment();
  EXPECT_EQ(workedOn(result), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(count(result.out, "\n"), 5U);
  EXPECT_LT(result.out.find("1305031450.5"), result.out.find("1305031454.5"));
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(namesIn(out()).size(), 15U);
  const auto document = nlohmann::json::parse(textOf(planes(4)));
  EXPECT_NEAR(document["planes"][0]["d"].get<double>(), 12000 / 5000.0, 0.001);
  EXPECT_EQ(document["settings"]["camera"], nlohmann::json({517.3, 516.5, 318.6, 255.3}));
}

TEST_F(SegmentFolder, GoesOnWhereItWas) {
  ASSERT_EQ(segment().exit_code, 0);
  const std::string before = textOf(planes(0));
  std::filesystem::remove(planes(1));
  std::filesystem::remove(out() + "/1305031453.5.overlay.png");
  folder_.write("out/1305031454.5.planes.json", "{\"frame\":");
  const ToolResult result = segment();
  EXPECT_EQ(workedOn(result), (std::vector<int>{1, 3, 4}));
  EXPECT_NE(result.out.find("2 frames were finished before"), std::string::npos) << result.out;
  EXPECT_EQ(textOf(planes(0)), before);
  EXPECT_EQ(workedOn(segment()), std::vector<int>{});
  // Results of earlier versions have only the older name of the depth unit.
  auto older = nlohmann::json::parse(before);
  EXPECT_EQ(older["settings"].erase("depth_unit"), 1U);
  folder_.write("out/1305031450.5.planes.json", older.dump());
  EXPECT_EQ(workedOn(segment()), std::vector<int>{});
  EXPECT_EQ(workedOn(segment({"--redo"})), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST_F(SegmentFolder, DoesNotTakeOtherResultsForFinished) {
  ASSERT_EQ(segment().exit_code, 0);
  EXPECT_EQ(workedOn(segment({"--set", "min_plane_inliers=900"})).size(), 5U) << "another parameter";
  EXPECT_EQ(workedOn(segment({"--set", "min_plane_inliers=900", "--depth-scale", "4000"})).size(), 5U)
      << "another scale";
  EXPECT_EQ(workedOn(segment()).size(), 5U) << "as at first";
  writeImage(2);
  std::filesystem::last_write_time(image(2),
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
  EXPECT_EQ(workedOn(segment()), std::vector<int>{2}) << "a newer image";
}

TEST_F(SegmentFolder, DoesNotTakeOtherContentOfTheSameAgeForFinished) {
  ASSERT_EQ(segment().exit_code, 0);
  const auto time = std::filesystem::last_write_time(image(2));
  cv::imwrite(image(2), cv::Mat(120, 160, CV_16UC1, cv::Scalar(9000)));
  std::filesystem::last_write_time(image(2), time);
  EXPECT_EQ(workedOn(segment()), std::vector<int>{2});
  std::string labels = textOf(out() + "/1305031451.5.labels.png");
  labels[labels.size() / 2] ^= 1;
  folder_.write("out/1305031451.5.labels.png", labels);
  folder_.write("out/1305031453.5.overlay.png", "");
  EXPECT_EQ(workedOn(segment()), (std::vector<int>{1, 3})) << "damaged results";
}

TEST_F(SegmentFolder, NeitherKeepsNorReplacesTheResultsOfAnotherSequence) {
  ASSERT_EQ(segment().exit_code, 0);
  const std::string before = textOf(planes(3));
  const std::string other = (folder_ / "rgbd_dataset_freiburg1_other").string();
  std::filesystem::create_directories(other + "/depth");
  const std::string other_image = other + "/depth/1305031453.5.png";
  cv::imwrite(other_image, cv::Mat(120, 160, CV_16UC1, cv::Scalar(7000)));
  const std::vector<std::string> arguments{"--dataset", "tum", "--out", out(), other};
  expectRefusal(runProcess(SEGMENT_DEPTH, arguments), "segment_depth",
                "made from another image of this name");
  EXPECT_EQ(textOf(planes(3)), before);
  std::filesystem::copy_file(image(3), other_image, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::last_write_time(other_image, std::filesystem::last_write_time(image(3)));
  EXPECT_NE(runProcess(SEGMENT_DEPTH, arguments).out.find("1 frames were finished before"), std::string::npos)
      << "a copy of the image";
  cv::imwrite(other_image, cv::Mat(120, 160, CV_16UC1, cv::Scalar(7000)));
  std::vector<std::string> redo = arguments;
  redo.push_back("--redo");
  ASSERT_EQ(runProcess(SEGMENT_DEPTH, redo).exit_code, 0);
  EXPECT_NEAR(nlohmann::json::parse(textOf(planes(3)))["planes"][0]["d"].get<double>(), 1.4, 0.001);
}

// SIGKILL is tested by output_files_test.
TEST_F(SegmentFolder, EndsOnSignalsAndLeavesNothingHalfWritten) {
  for (int i = 0; i < 300; ++i) {
    std::filesystem::copy_file(image(0),
                               folder_ / (std::string(kSequence) + "/depth/2" + std::to_string(i) + ".png"));
  }
  for (const char* signal : {"INT", "TERM", "HUP", "QUIT"}) {
    SCOPED_TRACE(signal);
    std::filesystem::remove_all(out());
    // The signal comes when there are first results. Job control, since without it SIGINT is ignored in the
    // background.
    const std::string command = "set -m; '" + std::string(SEGMENT_DEPTH) + "' --dataset tum --out '" + out() +
                                "' '" + (folder_ / kSequence).string() + "' & until ls '" + out() +
                                "'/*.planes.json >/dev/null 2>&1; do sleep 0.02; done; kill -" + signal +
                                " $!; wait $!";
    const ToolResult result = runProcess("/bin/bash", {"-c", command});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("segment_depth: interrupted"), std::string::npos) << result.err;
    const Names names = namesIn(out());
    EXPECT_LT(names.size(), 3U * 305U);
    EXPECT_EQ(names.size() % 3, 0U);
    for (const std::string& name : names) EXPECT_NE(name.front(), '.') << name;
  }
}

TEST_F(SegmentFolder, KeepsWhatIsFinishedWhenItFailsLater) {
  ASSERT_EQ(segment().exit_code, 0);
  std::filesystem::remove(planes(3));
  folder_.write(std::string(kSequence) + "/depth/1305031459.5.png", "no image");
  expectRefusal(segment(), "segment_depth", "1305031459.5.png: cannot be read");
  EXPECT_FALSE(std::filesystem::exists(planes(3))) << "wrong input is to be told before anything is written";
  EXPECT_EQ(namesIn(out()).size(), 14U);
}

TEST_F(SegmentFolder, TakesAPlainFolder) {
  const ToolResult result =
      runProcess(SEGMENT_DEPTH, {"--camera", "500,500,80,60", "--depth-scale", "5000", "--jobs", "1", "--out",
                                 out(), (folder_ / kSequence / "depth").string()});
  EXPECT_EQ(workedOn(result).size(), 5U);
}

TEST_F(SegmentFolder, RefusesWrongOptions) {
  expectRefusal(segment({(folder_ / kSequence).string()}), "segment_depth", "one FOLDER");
  expectRefusal(segment({"--jobs", "-1"}), "segment_depth", "--jobs");
  expectRefusal(segment({"--frames-csv", "frames.csv"}), "segment_depth", "one or the other");
  expectRefusal(segment({"--camera", "1,2"}), "segment_depth", "FX,FY,CX,CY");
  std::filesystem::create_directory(folder_ / "empty");
  expectRefusal(runProcess(SEGMENT_DEPTH, {"--camera", "500,500,80,60", "--depth-scale", "5000", "--out",
                                           out(), (folder_ / "empty").string()}),
                "segment_depth", "empty: there is no *.png");
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(SegmentFolder, MakesAPageThatIsWholeInItself) {
  const std::string page = (folder_ / "page.html").string();
  // The results of an earlier run are shown, too.
  ASSERT_EQ(segment().exit_code, 0);
  std::filesystem::remove(planes(1));
  ASSERT_EQ(segment({"--report", page, "--set", "noise_growth=0.0019"}).exit_code, 0);
  const std::string html = textOf(page);
  EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0U);
  EXPECT_EQ(count(html, "<article id="), 5U);
  EXPECT_EQ(count(html, "src=\"data:image/jpeg;base64,"), 5U);
  EXPECT_EQ(count(html, "src="), 5U) << "something comes from outside";
  for (const char* outside : {"<script", "<link", "http:", "https:", "url(", "@import"}) {
    EXPECT_EQ(count(html, outside), 0U) << outside;
  }
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(count(html, "<h2>130503145" + std::to_string(i) + ".5</h2>"), 1U);
    EXPECT_EQ(count(html, "href=\"#frame-" + std::to_string(i) + "\""), 1U) << "the plot leads to each frame";
  }
  for (const char* words :
       {"Parameters: the defaults.", "<td>2.400</td>", "extraction", "total [ms]", "</html>"}) {
    EXPECT_GE(count(html, words), 1U) << words;
  }
  EXPECT_EQ(namesIn(folder_.path()), (Names{"out", "page.html", kSequence}));
}

TEST_F(SegmentFolder, APictureInThePageIsTheOverlay) {
  const std::string page = out() + "/page.html";
  ASSERT_EQ(segment({"--report", page, "--set", "min_range=0.5"}).exit_code, 0);
  const std::string html = textOf(page);
  EXPECT_GE(count(html, "Parameters: min_range = 0.5."), 1U);
  const std::string mark = "base64,";
  const std::size_t begin = html.find(mark) + mark.size();
  folder_.write("picture.b64", html.substr(begin, html.find('"', begin) - begin));
  const std::string jpeg = (folder_ / "picture.jpg").string();
  const std::string command = "base64 -d '" + (folder_ / "picture.b64").string() + "' >'" + jpeg + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const cv::Mat shown = cv::imread(jpeg);
  const cv::Mat overlay = cv::imread(out() + "/1305031450.5.overlay.png");
  ASSERT_EQ(shown.size(), overlay.size());
  EXPECT_LT(cv::norm(shown, overlay, cv::NORM_L1) / static_cast<double>(3 * overlay.total()), 4.0);
}

TEST_F(SegmentFolder, RefusesAPageThatCannotBe) {
  expectRefusal(segment({"--report", (folder_ / "missing/page.html").string()}), "segment_depth",
                "no folder for this report");
  expectRefusal(segment({"--report", folder_.path().string()}), "segment_depth", "is a folder");
  expectRefusal(segment({"--report", out() + "/1305031450.5.planes.json"}), "segment_depth",
                "would overwrite a result");
  expectRefusal(segment({"--report", image(0)}), "segment_depth", "would overwrite an image");
  std::filesystem::create_hard_link(image(0), folder_ / "hard.png");
  expectRefusal(segment({"--report", (folder_ / "hard.png").string()}), "segment_depth",
                "would overwrite the input");
  folder_.write(std::string(kSequence) + "/frames.csv",
                "frame,width,height,units_per_metre,fx,fy,cx,cy\n1305031450.5,160,120,5000,525,525,80,60\n");
  const std::string table = (folder_ / kSequence / "frames.csv").string();
  expectRefusal(runProcess(SEGMENT_DEPTH, {"--frames-csv", table, "--out", out(), "--report", table}),
                "segment_depth", "would overwrite the input");
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(SegmentFolder, TellsWhenThePageCannotBeWritten) {
  const ToolResult full = segment({"--report", "/dev/full"});
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.err, "segment_depth: /dev/full: cannot be written, No space left on device\n");
  EXPECT_NE(segment({"--report", (folder_ / "page.html").string()}).out.find("finished before"),
            std::string::npos)
      << "the results are complete";
}

}  // namespace
}  // namespace line_plane_segmentation
