// SPDX-License-Identifier: BSD-3-Clause
#include "frame_processor.h"

#include <thread>

#include "conversions.h"

namespace line_plane_segmentation {
namespace {

using Clock = std::chrono::steady_clock;

// Frames that tf has not known for this long are treated as unavailable. Images then no longer wait for
// them, so a system without tf has no extra latency.
constexpr std::chrono::seconds kUnknownAfter(1);

}  // namespace

FrameProcessor::FrameProcessor(const std::string& name, const InputLimits& limits, std::size_t queue_size,
                               const Outputs& outputs, TransformListener& transforms)
    : outputs_(outputs),
      transforms_(transforms),
      warnings_(name),
      robot_(name),
      segmenter_(limits),
      locator_(transforms.buffer()),
      mailbox_(
          queue_size, [this](const InputFrame& frame) { process(frame); },
          [this](const std::string& problem) {
            statistics_.failed(problem);
            warnings_.warnAboutFailure(problem);
          }) {}

FrameProcessor::~FrameProcessor() { segmenter_.stop(); }

void FrameProcessor::setParameters(const NodeletParameters& parameters) {
  const std::lock_guard<std::mutex> lock(parameters_mutex_);
  parameters_ = parameters;
  parameters_changed_ = true;
}

void FrameProcessor::applyParameters() {
  const bool trace_outlines = outputs_.needsOutlines();
  NodeletParameters parameters;
  {
    const std::lock_guard<std::mutex> lock(parameters_mutex_);
    if (!parameters_changed_ && trace_outlines == tracing_outlines_) return;
    parameters_changed_ = false;
    parameters = parameters_;
  }
  tracing_outlines_ = trace_outlines;
  parameters.method.outlines.trace_outlines &= trace_outlines;
  segmenter_.setParameters(parameters.method);
  locator_.setParameters(parameters.location);
  robot_.setParameters(parameters.robot, parameters.method.noise, parameters.location.tracking);
  unknown_since_ = {};
}

// True if waiting may help: when tf has just started, or a bag loops, the first transforms arrive at about
// the same time as the first image.
bool FrameProcessor::mayBecomeAvailable(const CameraPoses& poses) {
  using Status = TransformLookup::Status;
  const std::array lookups = poses.all();
  const Clock::time_point now = Clock::now();
  bool may_come = poses.has(Status::kLate);
  for (std::size_t i = 0; i < lookups.size(); ++i) {
    std::optional<Clock::time_point>& since = unknown_since_[i];
    since = lookups[i]->status == Status::kUnknown ? since.value_or(now) : std::optional<Clock::time_point>();
    may_come |= since && now - *since < kUnknownAfter;
  }
  return may_come;
}

// The patience counts from the frame's arrival: the frames behind it wait at the same time, so that none of
// them is lost. Until the connection to tf is established frames wait longer, as long as the mailbox
// takes them.
bool FrameProcessor::mayWaitLonger(const InputFrame& frame) {
  if (mailbox_.isStopping()) return false;
  const std::chrono::duration<double> patience(locator_.parameters().frames.tf_patience);
  return Clock::now() - frame.arrived < patience || (transforms_.isConnecting() && !mailbox_.nearlyFull());
}

// Transforms often arrive a little later than the image that they belong to. This thread waits for them,
// since no callback may, by a clock that does not depend on ROS time.
CameraPoses FrameProcessor::lookUpPoses(const InputFrame& frame) {
  constexpr std::chrono::milliseconds kPause(2);
  CameraPoses poses = locator_.lookUp(segmenter_.header());
  while (mayBecomeAvailable(poses) && mayWaitLonger(frame)) {
    std::this_thread::sleep_for(kPause);
    poses = locator_.lookUp(segmenter_.header());
  }
  locator_.fallBack(segmenter_.header(), poses);
  return poses;
}

void FrameProcessor::warnAboutTransforms(const CameraPoses& poses) {
  const FrameParameters& frames = locator_.parameters().frames;
  if (!frames.target_frame.empty())
    warnings_.countLookup(TransformPurpose::kTarget, poses.target, frames.tf_patience);
  if (!frames.gravity_frame.empty())
    warnings_.countLookup(TransformPurpose::kGravity, poses.gravity, frames.tf_patience);
  if (!frames.fixed_frame.empty())
    warnings_.countLookup(TransformPurpose::kFixed, poses.fixed, frames.tf_patience);
}

void FrameProcessor::refuse(Refusal refusal, const std::string& explanation) {
  statistics_.refused(refusal, explanation, segmenter_.header().frame_id);
  // Single failed transforms are normal; warnAboutTransforms() warns if most of them fail.
  if (refusal != Refusal::kTf) warnings_.warnAboutRefusal(refusal, explanation);
}

const Validation& FrameProcessor::accept(const InputFrame& frame) {
  const ProcessingTime::Frame frame_time(processing_time_);
  return segmenter_.accept(frame);
}

void FrameProcessor::process(const InputFrame& frame) {
  if (!outputs_.subscribed()) return;
  applyParameters();
  const Validation& input = accept(frame);
  if (!input.accepted()) {
    refuse(input.refusal, segmenter_.explanation(frame));
    return;
  }
  warnings_.checkFrame(frame, input);

  const CameraPoses poses = lookUpPoses(frame);
  warnAboutTransforms(poses);
  if (!poses.target.found()) {
    refuse(Refusal::kTf, "planes cannot be given in ~target_frame: " +
                             explain(poses.target, locator_.parameters().frames.tf_patience));
    return;
  }
  const ProcessingTime::Frame frame_time(processing_time_);
  const Segmentation& segmentation = segmenter_.segment();
  if (segmenter_.isStopped()) return;
  warnings_.checkSegmentation(input, segmenter_.range(), segmentation);

  const auto outputs_started = std::chrono::steady_clock::now();
  const PublishedPlanes& published = locator_.locate(segmentation, input.camera, segmenter_.header(), poses);
  const SegmentedFrame result = segmenter_.result(published);
  statistics_.untracked(locator_.untracked());
  outputs_.publish(result, robot_);
  if (outputs_.needsScanlines()) {
    outputs_.publishScanlines(result, segmenter_.lineSegments(), segmenter_.candidates());
  }
  const std::chrono::duration<double, std::milli> output_time =
      std::chrono::steady_clock::now() - outputs_started;
  statistics_.processed(segmentation, published.planes.size(), segmenter_.clock(), output_time.count(),
                        segmenter_.header().frame_id, delayOf(segmenter_.header().stamp, ros::Time::now()));
}

}  // namespace line_plane_segmentation
