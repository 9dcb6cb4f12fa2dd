// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tools/temporary_folder.h"
#include "tools/tool_process.h"

namespace line_plane_segmentation {
namespace {

ToolResult run(const std::vector<std::string>& arguments) {
  return runProcess(BENCHMARK_SEGMENTATION, arguments);
}

void expectRefused(const std::vector<std::string>& arguments, const std::string& reason) {
  expectRefusal(run(arguments), "benchmark_segmentation", reason);
}

TEST(BenchmarkSegmentation, MeasuresARoom) {
  const TemporaryFolder folder;
  const ToolResult result = run({"--rooms", "1", "--repetitions", "1", "--slow-repetitions", "1", "--without",
                                 "rgs", "--no-scaling", "--out", (folder / "out").string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(namesIn(folder / "out"), (std::vector<std::string>{"benchmark.md", "scaling.csv", "stages.csv",
                                                               "times.csv", "times.png"}));
  EXPECT_EQ(textOf(folder / "out/benchmark.md"), result.out);
  const std::string times = textOf(folder / "out/times.csv");
  for (const std::string row : {"room 1,640,480,adaptive,", "room 1,320,240,paper_5,",
                                "room 1,640,480,omps_refined,", "room 1,320,240,ransac,"}) {
    EXPECT_NE(times.find('\n' + row), std::string::npos) << row;
  }
  EXPECT_EQ(times.find(",rgs,"), std::string::npos);
}

TEST(BenchmarkSegmentation, RefusesWhatItCannotDo) {
  expectRefused({"--rooms", "0"}, "--rooms must be");
  expectRefused({"--repetitions", "-1"}, "--repetitions must be");
  expectRefused({"--without", "luck"}, "'luck'");
  expectRefused({"--frames", "/nowhere"}, "/nowhere/frames.csv");
  expectRefused({"--pictures"}, "--out is missing");
  expectRefused({"surplus"}, "");
}

TEST(BenchmarkSegmentation, HelpNamesTheMethods) {
  const ToolResult result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* name : {"adaptive", "paper_3", "omps_refined", "ransac", "rgs"}) {
    EXPECT_NE(result.out.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace line_plane_segmentation
