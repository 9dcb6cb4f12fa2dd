// SPDX-License-Identifier: BSD-3-Clause
#include "frame_segmenter.h"

#include "line_plane_segmentation/ros/cloud_validation.h"

namespace line_plane_segmentation {
namespace {

std_msgs::Header withoutSlashes(std_msgs::Header header) {
  header.frame_id.erase(0, header.frame_id.find_first_not_of('/'));
  return header;
}

DepthRange rangeOf(const Parameters& parameters) {
  return {static_cast<float>(parameters.scanlines.min_range),
          static_cast<float>(parameters.scanlines.max_range)};
}

}  // namespace

const Validation& FrameSegmenter::accept(const CameraFrame& frame) {
  header_ = withoutSlashes(frame.header());
  input_ = frame.cloud ? validate(*frame.cloud, limits_, cloud_depth_)
                       : validate(*frame.image, *frame.info, limits_);
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

std::string FrameSegmenter::explanation(const CameraFrame& frame) const {
  return frame.cloud ? explain(input_.refusal, *frame.cloud)
                     : explain(input_.refusal, *frame.image, *frame.info);
}

SegmentedFrame FrameSegmenter::result(const PublishedPlanes& published) const {
  return {header_, input_.view, range_, input_.camera, *segmentation_, published, clock_.totalMilliseconds()};
}

}  // namespace line_plane_segmentation
