// SPDX-License-Identifier: BSD-3-Clause
#include "frame_processor.h"

#include <chrono>
#include <exception>

#include "line_plane_segmentation/ros/conversions.h"

namespace line_plane_segmentation {
namespace {

// tf2 refuses names that start with a slash.
std_msgs::Header withoutSlash(std_msgs::Header header) {
  if (!header.frame_id.empty() && header.frame_id.front() == '/') header.frame_id.erase(0, 1);
  return header;
}

DepthRange rangeOf(const Parameters& parameters) {
  return {static_cast<float>(parameters.scanlines.min_range),
          static_cast<float>(parameters.scanlines.max_range)};
}

}  // namespace

FrameProcessor::FrameProcessor(const std::string& name, const InputLimits& limits, std::size_t queue_size,
                               const Outputs& outputs)
    : limits_(limits), outputs_(outputs), queue_(queue_size), advice_(name), thread_([this] { run(); }) {}

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
  const std_msgs::Header header = withoutSlash(frame.image->header);
  const Validation input = validate(*frame.image, *frame.info, limits_);
  if (!input.accepted()) {
    const std::string explanation = explain(input.refusal, *frame.image, *frame.info);
    statistics_.refused(input.refusal, explanation, header.frame_id);
    advice_.refused(input.refusal, explanation);
    return;
  }
  advice_.accepted(frame, input);

  applyParameters();
  const DepthRange range = rangeOf(segmenter_.parameters());
  const Segmentation& segmentation = segmenter_.segment(input.view, input.camera, &clock_);
  advice_.segmented(input, range, segmentation);

  const auto outputs_started = std::chrono::steady_clock::now();
  idsFromLabels(segmentation, ids_);
  outputs_.publish({header, input.view, range, input.camera, segmentation, ids_, clock_.totalMilliseconds()});
  const std::chrono::duration<double, std::milli> output_time =
      std::chrono::steady_clock::now() - outputs_started;
  statistics_.processed(segmentation, clock_, output_time.count(), header.frame_id);
}

}  // namespace line_plane_segmentation
