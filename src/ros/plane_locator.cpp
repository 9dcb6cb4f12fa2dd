// SPDX-License-Identifier: BSD-3-Clause
#include "plane_locator.h"

#include <algorithm>

namespace line_plane_segmentation {
namespace {

// The upper bound of TrackingParameters::track_memory.
constexpr double kLongestPause = 60.0;  // [s]

}  // namespace

bool CameraPlaces::has(TransformLookup::Answer answer) const {
  const std::array lookups = all();
  return std::any_of(lookups.begin(), lookups.end(),
                     [answer](const TransformLookup* lookup) { return lookup->answer == answer; });
}

std::optional<Eigen::Isometry3d> PlaneLocator::poseIn(const std::string& frame,
                                                      const TransformLookup& lookup) {
  if (frame.empty() || !lookup.found()) return {};
  return lookup.transform;
}

void PlaneLocator::setParameters(const LocationParameters& parameters) {
  // Poses in different fixed frames have no common motion.
  if (parameters.frames.fixed_frame != parameters_.frames.fixed_frame) last_pose_.reset();
  parameters_ = parameters;
  tracker_.setParameters(parameters.tracking);
}

CameraPlaces PlaneLocator::lookUp(const std_msgs::Header& header) const {
  const auto ask = [&](const std::string& frame) {
    return line_plane_segmentation::lookUp(transforms_, frame.empty() ? header.frame_id : frame,
                                           header.frame_id, header.stamp);
  };
  const FrameParameters& frames = parameters_.frames;
  return {ask(frames.target_frame), ask(frames.gravity_frame), ask(frames.fixed_frame)};
}

void PlaneLocator::fallBack(const std_msgs::Header& header, CameraPlaces& places) const {
  if (parameters_.frames.tf_fallback != kLatestTransform) return;
  std_msgs::Header newest = header;
  newest.stamp = ros::Time();
  const CameraPlaces latest = lookUp(newest);
  if (!places.target.found()) places.target = latest.target;
  if (!places.gravity.found()) places.gravity = latest.gravity;
  if (!places.fixed.found()) places.fixed = latest.fixed;
}

bool PlaneLocator::isAnotherTime(const ros::Time& stamp) const {
  // ros::Time::operator- throws if the difference is too large.
  return last_stamp_ && (stamp < *last_stamp_ || stamp.toSec() - last_stamp_->toSec() > kLongestPause);
}

std::optional<Eigen::Isometry3d> PlaneLocator::motionTo(const CameraPlaces& places) {
  std::optional<Eigen::Isometry3d> motion;
  const std::optional<Eigen::Isometry3d> pose = poseIn(parameters_.frames.fixed_frame, places.fixed);
  if (pose && last_pose_) motion = pose->inverse() * *last_pose_;
  last_pose_ = pose;
  return motion;
}

const PublishedPlanes& PlaneLocator::locate(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                            const std_msgs::Header& header, const CameraPlaces& places) {
  if (isAnotherTime(header.stamp)) {
    tracker_.reset();
    last_pose_.reset();
  }
  last_stamp_ = header.stamp;
  const std::optional<Eigen::Isometry3d> motion = motionTo(places);
  const std::vector<std::uint32_t>& ids =
      tracker_.track(segmentation, camera, header.stamp.toSec(), motion ? &*motion : nullptr);

  const FrameParameters& frames = parameters_.frames;
  published_.poses = {!frames.gravity_frame.empty(), poseIn(frames.gravity_frame, places.gravity),
                      frames.fixed_frame, poseIn(frames.fixed_frame, places.fixed)};
  std::optional<Eigen::Vector3d> up;
  if (published_.poses.gravity_from_optical) {
    up = published_.poses.gravity_from_optical->linear().transpose() * Eigen::Vector3d::UnitZ();
  }
  published_.header = header;
  if (!frames.target_frame.empty()) published_.header.frame_id = frames.target_frame;
  published_.placement = places.target.transform;
  publishPlanes(segmentation, ids, up, parameters_.orientation, published_);
  return published_;
}

}  // namespace line_plane_segmentation
