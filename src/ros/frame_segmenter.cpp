// SPDX-License-Identifier: BSD-3-Clause
#include "frame_segmenter.h"

namespace line_plane_segmentation {
namespace {

std_msgs::Header withoutSlash(std_msgs::Header header) {
  if (!header.frame_id.empty() && header.frame_id.front() == '/') header.frame_id.erase(0, 1);
  return header;
}

DepthRange rangeOf(const Parameters& parameters) {
  return {static_cast<float>(parameters.scanlines.min_range),
          static_cast<float>(parameters.scanlines.max_range)};
}

}  // namespace

const Validation& FrameSegmenter::accept(const CameraFrame& frame) {
  header_ = withoutSlash(frame.image->header);
  input_ = validate(*frame.image, *frame.info, limits_);
  return input_;
}

const Segmentation& FrameSegmenter::segment() {
  range_ = rangeOf(segmenter_.parameters());
  segmentation_ = &segmenter_.segment(input_.view, input_.camera, &clock_);
  return *segmentation_;
}

const Validation& FrameSegmenter::segment(const CameraFrame& frame) {
  if (accept(frame).accepted()) segment();
  return input_;
}

SegmentedFrame FrameSegmenter::result(const PublishedPlanes& published) const {
  return {header_, input_.view, range_, input_.camera, *segmentation_, published, clock_.totalMilliseconds()};
}

}  // namespace line_plane_segmentation
