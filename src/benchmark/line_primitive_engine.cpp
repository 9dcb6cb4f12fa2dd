// SPDX-License-Identifier: BSD-3-Clause
#include "line_primitive_engine.h"

#include "processor_clock.h"

namespace line_plane_segmentation {
namespace {

/// StageClock in processor time.
class ProcessorStageClock : public StageObserver {
 public:
  void frameStarted() override {
    times_.fill(0.0);
    last_ = processorMilliseconds();
  }
  void stageFinished(Stage stage) override {
    const double now = processorMilliseconds();
    times_[static_cast<std::size_t>(stage)] += now - last_;
    last_ = now;
  }
  const StageTimes& times() const { return times_; }

 private:
  StageTimes times_{};
  double last_ = 0.0;
};

class LinePrimitiveEngine : public Engine {
 public:
  explicit LinePrimitiveEngine(const Parameters& parameters) : segmenter_(parameters) {}

  void load(const BenchmarkFrame& frame) override { frame_ = &frame; }

  int segment() override {
    return static_cast<int>(segmenter_.segment(frame_->view(), frame_->camera, &clock_).planes.size());
  }

  std::vector<std::uint16_t> labels() override {
    return segmenter_.segment(frame_->view(), frame_->camera).labels;
  }

  const StageTimes* stageTimes() const override { return &clock_.times(); }

 private:
  PlaneSegmenter segmenter_;
  ProcessorStageClock clock_;
  const BenchmarkFrame* frame_ = nullptr;
};

}  // namespace

std::unique_ptr<Engine> makeLinePrimitiveEngine(const Parameters& parameters) {
  return std::make_unique<LinePrimitiveEngine>(parameters);
}

}  // namespace line_plane_segmentation
