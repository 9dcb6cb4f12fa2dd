// SPDX-License-Identifier: BSD-3-Clause
#include "robot_messages.h"

#include <ros/console.h>

namespace line_plane_segmentation {
namespace {

constexpr double kWarningPeriod = 60.0;  // [s]

}  // namespace

void RobotMessages::setParameters(const RobotParameters& robot, const NoiseParameters& noise,
                                  const TrackingParameters& tracking) {
  robot_ = robot;
  noise_ = noise;
  tracking_ = tracking;
}

void RobotMessages::setFrame(const SegmentedFrame& frame) {
  frame_ = &frame;
  objects_ = nullptr;
}

sensor_msgs::PointCloud2::Ptr RobotMessages::cloudWithoutPlanes() const {
  return line_plane_segmentation::cloudWithoutPlanes(*frame_, robot_.obstacles);
}

const std::vector<DetectedObject>& RobotMessages::detectedObjects() {
  if (objects_ != nullptr) return *objects_;
  const DepthScene scene{frame_->depth, frame_->range, frame_->camera, frame_->segmentation};
  objects_ = &detector_.detect(scene, supportsOf(*frame_), robot_.objects, noise_);
  return *objects_;
}

SupportedObjectArray::Ptr RobotMessages::objects() {
  if (!frame_->published.poses.gravity_frame_is_set) {
    ROS_WARN_THROTTLE(kWarningPeriod,
                      "[%s] no objects are detected: set ~gravity_frame, so that horizontal planes are known",
                      name_.c_str());
  }
  const std::vector<DetectedObject>& objects = detectedObjects();
  return objectsMessage(*frame_, objects, detector_.supports());
}

void RobotMessages::addObjectMarkers(visualization_msgs::MarkerArray& markers) {
  line_plane_segmentation::addObjectMarkers(*frame_, detectedObjects(), markers);
}

TrackedPlaneArray::Ptr RobotMessages::trackedPlanes() {
  if (frame_->published.poses.fixed_frame.empty()) {
    ROS_WARN_THROTTLE(kWarningPeriod,
                      "[%s] planes are not fused: set ~fixed_frame, in which they stand still",
                      name_.c_str());
  }
  return tracked_planes_.fuse(*frame_, robot_.fusion, tracking_);
}

}  // namespace line_plane_segmentation
