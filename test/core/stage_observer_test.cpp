// SPDX-License-Identifier: BSD-3-Clause
// What StageObserver promises: it is told of each stage, and may end a frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "support/synthetic_depth.h"

namespace line_plane_segmentation {
namespace {

class StageObserverTest : public testing::TestWithParam<Method> {
 protected:
  Parameters parameters() const {
    Parameters p;
    p.method = GetParam();
    return p;
  }
};

/// Writes down what it is told.
class Recorder : public StageObserver {
 public:
  void frameStarted() override { told.emplace_back("frame"); }
  void stageFinished(Stage stage) override { told.emplace_back(nameOf(stage)); }
  std::vector<std::string> told;
};

TEST_P(StageObserverTest, TellsItsStagesInTheirOrder) {
  const std::vector<std::uint16_t> pixels(320 * 240, 1500);
  PlaneSegmenter segmenter(parameters());
  Recorder recorder;
  segmenter.segment(viewOf(pixels.data(), 320, 240), kinectCamera(320, 240), &recorder);
  EXPECT_EQ(recorder.told, (std::vector<std::string>{"frame", "lines", "candidates", "extraction",
                                                     "refinement", "outlines"}));
}

/// Asks for a stop when it is polled for the n-th time.
class StopsAt : public StageObserver {
 public:
  explicit StopsAt(int n) : n_(n) {}
  void frameStarted() override {}
  void stageFinished(Stage) override {}
  bool isStopRequested() override { return ++polls >= n_; }
  int polls = 0;

 private:
  int n_;
};

TEST_P(StageObserverTest, GivesAFrameUpWhenAskedTo) {
  const std::vector<std::uint16_t> pixels(320 * 240, 1500);
  const DepthView view = viewOf(pixels.data(), 320, 240);
  PlaneSegmenter segmenter(parameters());
  StopsAt never(1000000);
  ASSERT_EQ(segmenter.segment(view, kinectCamera(320, 240), &never).planes.size(), 1U);
  ASSERT_GE(never.polls, kStageCount);
  for (int n = 1; n <= never.polls; n += 1 + never.polls / 20) {
    StopsAt stop(n);
    const Segmentation& segmentation = segmenter.segment(view, kinectCamera(320, 240), &stop);
    EXPECT_LE(stop.polls, n + 1) << "it goes on";
    EXPECT_TRUE(segmentation.planes.empty());
    EXPECT_EQ(std::count(segmentation.labels.begin(), segmentation.labels.end(), 0), 320 * 240);
    EXPECT_EQ(segmentation.assigned_pixels, 0U);
  }
  EXPECT_EQ(segmenter.segment(view, kinectCamera(320, 240)).planes.size(), 1U)
      << "the next frame is as any other";
}

INSTANTIATE_TEST_SUITE_P(Methods, StageObserverTest, testing::Values(Method::kPaper, Method::kAdaptive),
                         [](const auto& method) {
                           return method.param == Method::kPaper ? "Paper" : "Adaptive";
                         });

}  // namespace
}  // namespace line_plane_segmentation
