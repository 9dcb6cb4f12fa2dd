// SPDX-License-Identifier: BSD-3-Clause
#include "frame_processor.h"

#include <chrono>
#include <exception>

#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {

FrameProcessor::FrameProcessor(const std::string& name, const InputLimits& limits, std::size_t queue_size,
                               const Outputs& outputs)
    : outputs_(outputs), queue_(queue_size), advice_(name), segmenter_(limits), thread_([this] { run(); }) {}

FrameProcessor::~FrameProcessor() {
  queue_.close();
  thread_.join();
}

void FrameProcessor::setParameters(const Parameters& parameters) {
  const std::lock_guard<std::mutex> lock(parameters_mutex_);
  parameters_ = parameters;
  parameters_changed_ = true;
}

void FrameProcessor::run() {
  CameraFrame frame;
  while (queue_.pop(frame)) {
    std::string problem;
    try {
      process(frame);
    } catch (const std::exception& exception) {
      problem = exception.what();
    } catch (...) {
      problem = "an exception of unknown type";
    }
    if (!problem.empty()) {
      statistics_.failed(problem);
      advice_.failed(problem);
    }
    frame = CameraFrame{};
  }
}

void FrameProcessor::applyParameters() {
  const bool trace_outlines = outputs_.outlinesWanted();
  Parameters parameters;
  {
    const std::lock_guard<std::mutex> lock(parameters_mutex_);
    if (!parameters_changed_ && trace_outlines == tracing_outlines_) return;
    parameters_changed_ = false;
    parameters = parameters_;
  }
  tracing_outlines_ = trace_outlines;
  parameters.outlines.trace_outlines &= trace_outlines;
  segmenter_.setParameters(parameters);
}

void FrameProcessor::process(const CameraFrame& frame) {
  if (!outputs_.wanted()) return;
  applyParameters();
  const Validation& input = segmenter_.segment(frame);
  const std::string& frame_id = segmenter_.header().frame_id;
  if (!input.accepted()) {
    const std::string explanation = explain(input.refusal, *frame.image, *frame.info);
    statistics_.refused(input.refusal, explanation, frame_id);
    advice_.refused(input.refusal, explanation);
    return;
  }
  const Segmentation& segmentation = segmenter_.segmentation();
  advice_.accepted(frame, input);
  advice_.segmented(input, segmenter_.range(), segmentation);

  const auto outputs_started = std::chrono::steady_clock::now();
  ids_.clear();
  for (const SegmentedPlane& plane : segmentation.planes) ids_.push_back(plane.label);
  published_.header = segmenter_.header();
  publishPlanes(segmentation, ids_, std::nullopt, OrientationParameters{}, published_);
  outputs_.publish(segmenter_.result(published_));
  const std::chrono::duration<double, std::milli> output_time =
      std::chrono::steady_clock::now() - outputs_started;
  statistics_.processed(segmentation, segmenter_.clock(), output_time.count(), frame_id);
}

}  // namespace line_plane_segmentation
