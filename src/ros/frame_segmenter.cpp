// SPDX-License-Identifier: BSD-3-Clause
#include "frame_segmenter.h"

#include "cloud_validation.h"
#include "compressed_depth.h"
#include "printable_text.h"

namespace line_plane_segmentation {
namespace {

// Without leading slashes, which tf2 refuses; not longer than any name is.
std_msgs::Header usable(std_msgs::Header header) {
  header.frame_id.erase(0, header.frame_id.find_first_not_of('/'));
  if (header.frame_id.size() > kLongestFrameName) header.frame_id.resize(kLongestFrameName);
  return header;
}

DepthRange rangeOf(const Parameters& parameters) {
  return {static_cast<float>(parameters.scanlines.min_range),
          static_cast<float>(parameters.scanlines.max_range)};
}

}  // namespace

const Validation& FrameSegmenter::accept(const InputFrame& frame) {
  header_ = usable(frame.header());
  if (frame.cloud) {
    input_ = validate(*frame.cloud, limits_, cloud_depth_);
  } else {
    input_ = acceptImage(frame);
  }
  return input_;
}

Validation FrameSegmenter::acceptImage(const InputFrame& frame) {
  Validation input =
      frame.compressed ? acceptCompressed(frame) : validate(*frame.image, *frame.info, limits_);
  if (!input.accepted() || !input.distorted || !frame.needs_rectification) return input;
  if (!rectifier_.setCamera(*frame.info, input.view.width, input.view.height)) return input;
  input.view = rectifier_.rectify(input.view);
  input.camera = rectifier_.camera();
  input.distorted = false;
  return input;
}

Validation FrameSegmenter::acceptCompressed(const InputFrame& frame) {
  Validation refused;
  const std::uint64_t pixels = std::uint64_t{frame.image->width} * frame.image->height;
  if (pixels > limits_.max_pixels) {
    refused.refusal = Refusal::kTooLarge;
  } else if (!decodeCompressedDepth(*frame.compressed, limits_.max_pixels, decoded_)) {
    refused.refusal = Refusal::kUndecodable;
  } else {
    return validate(decoded_, *frame.info, limits_);
  }
  return refused;
}

const Segmentation& FrameSegmenter::segment() {
  range_ = rangeOf(segmenter_.parameters());
  segmentation_ = &segmenter_.segment(input_.view, input_.camera, &clock_);
  return *segmentation_;
}

const Validation& FrameSegmenter::segment(const InputFrame& frame) {
  if (accept(frame).accepted()) segment();
  return input_;
}

std::string FrameSegmenter::explanation(const InputFrame& frame) const {
  return frame.cloud ? explain(input_.refusal, *frame.cloud)
                     : explain(input_.refusal, *frame.image, *frame.info);
}

SegmentedFrame FrameSegmenter::result(const PublishedPlanes& published) const {
  return {header_, input_.view, range_, input_.camera, *segmentation_, published, clock_.totalMilliseconds()};
}

}  // namespace line_plane_segmentation
