// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "temporary_folder.h"
#include "tool_process.h"

namespace line_plane_segmentation {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

// An image of 10 rows, one value in each column.
cv::Mat columns(const std::vector<std::uint16_t>& values) {
  cv::Mat image(10, static_cast<int>(values.size()), CV_16UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) image.at<std::uint16_t>(v, u) = values[static_cast<std::size_t>(u)];
  }
  return image;
}

class EvaluateSegmentation : public testing::Test {
 protected:
  EvaluateSegmentation() {
    std::filesystem::create_directory(folder_ / "truth");
    std::filesystem::create_directory(folder_ / "labels");
  }

  void write(const std::string& name, const cv::Mat& image) const {
    cv::imwrite((folder_ / name).string(), image);
  }

  // Frame a: one region correct, one in pieces. Frame b: one correct, one of 20 pixels missed, one label too
  // much.
  void writeTwoFrames() const {
    write("truth/a.png", columns({1, 1, 1, 1, 1, 2, 2, 2, 2, 65535}));
    write("labels/a.labels.png", columns({5, 5, 5, 5, 0, 6, 6, 7, 7, 8}));
    write("truth/b.png", columns({1, 1, 1, 1, 2, 2, 0, 0, 0, 0}));
    write("labels/b.png", columns({1, 1, 1, 1, 0, 0, 0, 3, 3, 0}));
  }

  ToolResult evaluate(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"--truth", (folder_ / "truth").string(), "--labels",
                                       (folder_ / "labels").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProcess(EVALUATE_SEGMENTATION, arguments);
  }

  void expectRefused(const ToolResult& result, const std::string& reason) const {
    expectRefusal(result, "evaluate_segmentation", reason);
    EXPECT_EQ(namesIn(folder_.path()), (Names{"labels", "truth"})) << "left something behind";
  }

  TemporaryFolder folder_;
};

TEST_F(EvaluateSegmentation, NeverOverwritesAnImage) {
  writeTwoFrames();
  for (const char* name : {"truth/a.png", "labels/a.labels.png", "labels/b.png"}) {
    const std::string before = textOf(folder_ / name);
    for (const char* option : {"--json", "--curve"}) {
      expectRefused(evaluate({option, (folder_ / name).string()}), "would overwrite the input");
    }
    EXPECT_EQ(textOf(folder_ / name), before);
  }
}

TEST_F(EvaluateSegmentation, KnownAnswer) {
  writeTwoFrames();
  const std::string file = (folder_ / "scores.json").string();
  const ToolResult result = evaluate({"--json", file});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* word : {"\na ", "\nb ", "\nall 2 frames"})
    EXPECT_NE(result.out.find(word), std::string::npos) << result.out;

  const json document = json::parse(textOf(file));
  EXPECT_EQ(document["tolerance"], 0.8);
  ASSERT_EQ(document["frames"].size(), 2U);
  EXPECT_EQ(document["frames"][0]["frame"], "a");
  EXPECT_EQ(document["frames"][0]["correct"], 1);
  EXPECT_EQ(document["frames"][0]["over_segmented"], 1);
  EXPECT_EQ(document["frames"][0]["label_regions"], 3);
  EXPECT_EQ(document["frames"][1]["missed"], 1);
  EXPECT_EQ(document["frames"][1]["noise"], 1);

  const json& set = document["set"];
  EXPECT_EQ(set["truth_regions"], 4);
  EXPECT_EQ(set["label_regions"], 5);
  EXPECT_EQ(set["correct_rate"], 0.5);
  EXPECT_DOUBLE_EQ(set["precision"].get<double>(), 2.0 / 5.0);
  EXPECT_DOUBLE_EQ(set["recall"].get<double>(), 2.0 / 4.0);
  EXPECT_DOUBLE_EQ(set["mean_iou"].get<double>(), (0.8 + 0.5 + 1.0 + 0.0) / 4.0);
  EXPECT_DOUBLE_EQ(set["matched_iou"].get<double>(), 0.9);
  EXPECT_DOUBLE_EQ(set["pq"].get<double>(), 4.0 / 9.0 * 0.9);
  EXPECT_DOUBLE_EQ(set["covering"].get<double>(), (50 * 0.8 + 40 * 0.5 + 40 * 1.0) / 150.0);
}

TEST_F(EvaluateSegmentation, HeedsToleranceAndSmallestRegion) {
  writeTwoFrames();
  const std::string file = (folder_ / "scores.json").string();
  ASSERT_EQ(evaluate({"--json", file, "--tolerance", "0.85", "--min-pixels", "21"}).exit_code, 0);
  const json set = json::parse(textOf(file))["set"];
  EXPECT_EQ(set["truth_regions"], 3);
  EXPECT_EQ(set["correct"], 1);
  EXPECT_EQ(set["missed"], 1);
}

TEST_F(EvaluateSegmentation, WritesNullWhereThereIsNothingToJudge) {
  write("truth/a.png", columns({0, 0}));
  write("labels/a.png", columns({0, 0}));
  const std::string file = (folder_ / "scores.json").string();
  ASSERT_EQ(evaluate({"--json", file}).exit_code, 0);
  EXPECT_TRUE(json::parse(textOf(file))["set"]["recall"].is_null());
}

TEST_F(EvaluateSegmentation, DrawsTheCurve) {
  writeTwoFrames();
  const std::string file = (folder_ / "curve.png").string();
  ASSERT_EQ(evaluate({"--curve", file}).exit_code, 0);
  EXPECT_EQ(cv::imread(file, cv::IMREAD_UNCHANGED).type(), CV_8UC3);
}

// Two frames of a wall, which fills the image; the second one has another region on it that cannot be found.
void writeSet(const TemporaryFolder& folder) {
  folder.write("frames.csv",
               "frame,width,height,units_per_metre,fx,fy,cx,cy\n"
               "a,320,240,1000,262,262,159.5,119.5\nb,320,240,1000,262,262,159.5,119.5\n");
  const cv::Mat depth(240, 320, CV_16UC1, cv::Scalar(1500));
  cv::Mat truth(240, 320, CV_16UC1, cv::Scalar(1));
  for (const char* name : {"depth", "truth"}) std::filesystem::create_directory(folder / name);
  for (const char* file : {"depth/a.png", "depth/b.png"}) cv::imwrite((folder / file).string(), depth);
  cv::imwrite((folder / "truth/a.png").string(), truth);
  truth(cv::Rect(100, 100, 50, 50)).setTo(2);
  cv::imwrite((folder / "truth/b.png").string(), truth);
}

TEST_F(EvaluateSegmentation, EvaluatesASetRobustly) {
  const TemporaryFolder set;
  writeSet(set);
  const std::string file = (folder_ / "scores.json").string();
  for (const auto& [half, recall] : std::map<std::string, double>{{"even", 1.0}, {"odd", 0.5}}) {
    const ToolResult result =
        runProcess(EVALUATE_SEGMENTATION, {"--robust", set.path().string(), "--half", half, "--json", file});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("| correct |"), std::string::npos) << result.out;
    const json scores = json::parse(textOf(file))["sets"][0];
    EXPECT_EQ(scores["frames"], 1);
    EXPECT_EQ(scores["variants"], 40);
    EXPECT_DOUBLE_EQ(scores["recall"]["mean"].get<double>(), recall);
    EXPECT_DOUBLE_EQ(scores["recall"]["spread"].get<double>(), 0.0);
    EXPECT_EQ(scores["flips"], 0.0);
  }
}

TEST_F(EvaluateSegmentation, RobustModeHeedsParameters) {
  const TemporaryFolder set;
  writeSet(set);
  const std::vector<std::string> arguments{"--robust", set.path().string(), "--set", "max_range=1.0"};
  EXPECT_NE(runProcess(EVALUATE_SEGMENTATION, arguments).out.find("| 0.000 ± 0.000 |"), std::string::npos);
}

TEST_F(EvaluateSegmentation, RobustModeRefusesWrongInput) {
  const TemporaryFolder set;
  const std::string folder = set.path().string();
  expectRefused(runProcess(EVALUATE_SEGMENTATION, {"--robust", folder}), "frames.csv: cannot be read");
  writeSet(set);
  expectRefused(runProcess(EVALUATE_SEGMENTATION, {"--robust", folder, "--half", "third"}), "odd or even");
  expectRefused(runProcess(EVALUATE_SEGMENTATION, {"--robust", folder, "--set", "nonsense=1"}), "nonsense");
  std::filesystem::remove(set / "truth/b.png");
  expectRefused(runProcess(EVALUATE_SEGMENTATION, {"--robust", folder}), "truth/b.png: no such file");
}

TEST_F(EvaluateSegmentation, ExplainsItself) {
  const ToolResult result = runProcess(EVALUATE_SEGMENTATION, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("--min-pixels"), std::string::npos);
}

TEST_F(EvaluateSegmentation, RefusesFoldersThatDoNotFit) {
  expectRefused(evaluate(), "no PNG in this folder");
  write("truth/a.png", columns({1, 1}));
  expectRefused(evaluate(), "neither a.labels.png nor a.png");
  write("labels/a.png", columns({1, 1, 1}));
  expectRefused(evaluate(), "differs in size");
  write("labels/a.png", cv::Mat(10, 2, CV_8UC1, cv::Scalar(1)));
  expectRefused(evaluate(), "has 8 bits");
  std::filesystem::remove_all(folder_ / "truth/a.png");
  folder_.write("truth/a.png", "broken");
  expectRefused(evaluate(), "truth/a.png: cannot be read");
}

TEST_F(EvaluateSegmentation, RefusesWrongOptions) {
  writeTwoFrames();
  expectRefused(runProcess(EVALUATE_SEGMENTATION, {"--truth", (folder_ / "truth").string()}),
                "--labels is missing");
  expectRefused(runProcess(EVALUATE_SEGMENTATION, {"--truth", "/missing", "--labels", "/missing"}),
                "/missing: no such folder");
  expectRefused(evaluate({"--tolerance", "0.5"}), "above 0.5");
  expectRefused(evaluate({"--tolerance", "1.1"}), "at most 1");
  expectRefused(evaluate({"--tolerance", "nan"}), "above 0.5");
  expectRefused(evaluate({"--min-pixels", "-1"}), "--min-pixels");
  expectRefused(evaluate({"stray"}), "too many positional options");
  expectRefused(evaluate({"--json", (folder_ / "missing/scores.json").string(), "--curve",
                          (folder_ / "curve.png").string()}),
                "missing/scores.json: cannot be written");
}

}  // namespace
}  // namespace line_plane_segmentation
