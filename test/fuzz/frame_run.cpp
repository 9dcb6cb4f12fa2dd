// SPDX-License-Identifier: BSD-3-Clause
#include "frame_run.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "depth/depth_image.h"
#include "drawn_parameters.h"
#include "output_checks.h"
#include "support/segmentation_checks.h"

namespace line_plane_segmentation {
namespace {

// So that no frame takes long.
constexpr InputLimits kLimits{4096};

// Holds no transforms and is never asked: what tf tells comes from the bytes, too.
tf2::BufferCore& noTransforms() {
  static tf2::BufferCore buffer;
  return buffer;
}

TransformLookup drawTransform(ByteReader& bytes) {
  TransformLookup lookup;
  if (bytes.chance(32)) return lookup;
  lookup.status = TransformLookup::Status::kFound;
  const Eigen::Vector3d axis(bytes.uniform(-1.0, 1.0), bytes.uniform(-1.0, 1.0), bytes.uniform(0.1, 1.0));
  lookup.transform.linear() =
      Eigen::AngleAxisd(bytes.uniform(0.0, 3.2), axis.normalized()).toRotationMatrix();
  for (int i = 0; i < 3; ++i) lookup.transform.translation()[i] = bytes.uniform(0.0, 10.0);
  return lookup;
}

void expectSoundSegmentation(const FrameSegmenter& segmenter) {
  DepthImage depth;
  loadDepth(segmenter.input().view, segmenter.range(), depth);
  expectConsistent(segmenter.segmentation(), depth);
}

}  // namespace

FrameRun::FrameRun(ByteReader& bytes) : FrameRun(drawParameters(bytes)) {
  locator_.setParameters(drawLocationParameters(bytes));
}

FrameRun::FrameRun(const Parameters& parameters)
    : parameters_(parameters), segmenter_(kLimits), locator_(noTransforms()) {
  segmenter_.setParameters(parameters_);
}

void FrameRun::process(const InputFrame& frame, ByteReader& bytes) {
  const Validation& input = segmenter_.segment(frame);
  expectExplained(input, segmenter_.explanation(frame));
  if (!input.accepted()) return;
  expectSoundSegmentation(segmenter_);
  const CameraPoses poses{drawTransform(bytes), drawTransform(bytes), drawTransform(bytes)};
  const PublishedPlanes& published =
      locator_.locate(segmenter_.segmentation(), input.camera, segmenter_.header(), poses);
  expectSoundMessages(segmenter_, published);
}

void FrameRun::expectRepeatable(const InputFrame& frame) {
  FrameSegmenter other(kLimits);
  other.setParameters(parameters_);
  EXPECT_EQ(other.segment(frame).refusal, segmenter_.segment(frame).refusal);
  if (other.input().accepted()) expectSameBits(other.segmentation(), segmenter_.segmentation());
}

InputFrame frameOf(const sensor_msgs::Image& image, const sensor_msgs::CameraInfo& info) {
  InputFrame frame;
  frame.image = boost::make_shared<sensor_msgs::Image>(image);
  frame.info = boost::make_shared<sensor_msgs::CameraInfo>(info);
  return frame;
}

void tryFrames(ByteReader& bytes, InputFrame (*draw)(ByteReader&)) {
  const InputFrame first = draw(bytes);
  FrameRun run(bytes);
  run.process(first, bytes);
  if (bytes.chance(64)) run.process(draw(bytes), bytes);
  run.expectRepeatable(first);
}

}  // namespace line_plane_segmentation
