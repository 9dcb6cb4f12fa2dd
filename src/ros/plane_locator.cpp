// SPDX-License-Identifier: BSD-3-Clause
#include "plane_locator.h"

#include <algorithm>

namespace line_plane_segmentation {
namespace {

// The upper bound of TrackingParameters::track_memory.
constexpr double kLongestPause = 60.0;  // [s]

}  // namespace

bool CameraPoses::has(TransformLookup::Status status) const {
  const std::array lookups = all();
  return std::any_of(lookups.begin(), lookups.end(),
                     [status](const TransformLookup* lookup) { return lookup->status == status; });
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

CameraPoses PlaneLocator::lookUp(const std_msgs::Header& header) const {
  const auto look_up = [&](const std::string& frame) {
    return line_plane_segmentation::lookUp(transforms_, frame.empty() ? header.frame_id : frame,
                                           header.frame_id, header.stamp);
  };
  const FrameParameters& frames = parameters_.frames;
  return {look_up(frames.target_frame), look_up(frames.gravity_frame), look_up(frames.fixed_frame)};
}

void PlaneLocator::fallBack(const std_msgs::Header& header, CameraPoses& poses) const {
  if (parameters_.frames.tf_fallback != kLatestTransform) return;
  std_msgs::Header newest = header;
  newest.stamp = ros::Time();
  const CameraPoses latest = lookUp(newest);
  if (!poses.target.found()) poses.target = latest.target;
  if (!poses.gravity.found()) poses.gravity = latest.gravity;
  if (!poses.fixed.found()) poses.fixed = latest.fixed;
}

bool PlaneLocator::isTimeJump(const ros::Time& stamp) const {
  // ros::Time::operator- throws if the difference is too large.
  return last_stamp_ && (stamp < *last_stamp_ || stamp.toSec() - last_stamp_->toSec() > kLongestPause);
}

std::optional<Eigen::Isometry3d> PlaneLocator::updateMotion(const CameraPoses& poses) {
  std::optional<Eigen::Isometry3d> motion;
  const std::optional<Eigen::Isometry3d> pose = poseIn(parameters_.frames.fixed_frame, poses.fixed);
  if (pose && last_pose_) motion = pose->inverse() * *last_pose_;
  last_pose_ = pose;
  return motion;
}

const PublishedPlanes& PlaneLocator::locate(const Segmentation& segmentation, const CameraIntrinsics& camera,
                                            const std_msgs::Header& header, const CameraPoses& poses) {
  if (isTimeJump(header.stamp)) {
    tracker_.reset();
    last_pose_.reset();
  }
  last_stamp_ = header.stamp;
  const std::optional<Eigen::Isometry3d> motion = updateMotion(poses);
  const std::vector<std::uint32_t>& ids =
      tracker_.track(segmentation, camera, header.stamp.toSec(), motion ? &*motion : nullptr);

  const FrameParameters& frames = parameters_.frames;
  published_.poses = {!frames.gravity_frame.empty(), poseIn(frames.gravity_frame, poses.gravity),
                      frames.fixed_frame, poseIn(frames.fixed_frame, poses.fixed)};
  std::optional<Eigen::Vector3d> up;
  if (published_.poses.gravity_from_optical) {
    up = published_.poses.gravity_from_optical->linear().transpose() * Eigen::Vector3d::UnitZ();
  }
  published_.header = header;
  if (!frames.target_frame.empty()) published_.header.frame_id = frames.target_frame;
  published_.target_from_optical = poses.target.transform;
  publishPlanes(segmentation, ids, up, parameters_.orientation, published_);
  return published_;
}

}  // namespace line_plane_segmentation
