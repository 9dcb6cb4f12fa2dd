// SPDX-License-Identifier: BSD-3-Clause
#include "tracked_planes.h"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <iterator>
#include <utility>
#include <vector>

#include "marker_tools.h"
#include "plane_message.h"
#include "plane_polygons.h"

namespace line_plane_segmentation {
namespace {

// Largest number of invisible planes, as in PlaneTracker.
constexpr std::size_t kMaxHiddenPlanes = 128;

constexpr double kLongestPause = 60.0;  // [s] ids restart after a longer pause

void writeFilter(const PlaneTrackFilter& filter, TrackedPlane& message) {
  setCoefficients(filter.normal(), filter.d(), filter.covariance(), message.plane);
  message.observations = filter.observations();
}

}  // namespace

void TrackedPlanes::removeHidden(const ros::Time& stamp, double memory) {
  std::vector<std::pair<ros::Time, std::uint32_t>> hidden;
  for (const auto& [id, track] : tracks_) {
    if (!track.message.visible) hidden.emplace_back(track.message.last_seen, id);
  }
  std::sort(hidden.rbegin(), hidden.rend());  // the newest first
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    const bool is_old = stamp.toSec() - hidden[i].first.toSec() > memory;
    if (is_old || i >= kMaxHiddenPlanes) tracks_.erase(hidden[i].second);
  }
}

void TrackedPlanes::updateTrack(const SegmentedFrame& frame, const PublishedPlane& published, double seconds,
                                const CameraVelocity& velocity, const FusionParameters& parameters) {
  const Eigen::Isometry3d& fixed_from_optical = *frame.published.poses.fixed_from_optical;
  const ros::Time& stamp = frame.header.stamp;
  // In the optical frame, where its covariance is smallest.
  const SegmentedPlane& measured = frame.segmentation.planes[published.plane.label - std::size_t{1}];
  auto track = tracks_.find(published.id);
  if (track == tracks_.end()) {
    track = tracks_
                .emplace(published.id,
                         Track{PlaneTrackFilter(measured, fixed_from_optical, parameters, velocity), {}})
                .first;
    track->second.message.first_seen = stamp;
  } else {
    track->second.filter.predict(seconds, parameters);
    track->second.filter.update(measured, fixed_from_optical, parameters, velocity);
  }
  const PlaneTrackFilter& filter = track->second.filter;
  TrackedPlane& message = track->second.message;
  message.plane = planeWithoutPolygons(published);
  message.plane.centroid = pointOf(filter.projected(fixed_from_optical * measured.centroid));
  addPolygons(
      frame.segmentation, measured,
      [&](std::size_t vertex) -> Eigen::Vector3f {
        const Eigen::Vector3d point = frame.segmentation.vertices[vertex].cast<double>();
        return filter.projected(fixed_from_optical * point).cast<float>();
      },
      message.plane);
  writeFilter(filter, message);
  message.last_seen = stamp;
  message.visible = true;
}

TrackedPlaneArray::Ptr TrackedPlanes::fuse(const SegmentedFrame& frame, const FusionParameters& parameters,
                                           const TrackingParameters& tracking) {
  const FramePoses& poses = frame.published.poses;
  if (!poses.fixed_from_optical) return nullptr;
  const ros::Time& stamp = frame.header.stamp;
  // Computed in double, because ros::Time::operator- throws if the difference is too large.
  const double seconds = last_stamp_ ? stamp.toSec() - last_stamp_->toSec() : 0.0;
  // Without tracking, an id is a label, which changes from image to image.
  if (!tracking.track_planes || seconds < 0.0 || seconds > kLongestPause ||
      poses.fixed_frame != fixed_frame_) {
    tracks_.clear();
  }
  const bool has_last_pose = last_stamp_ && poses.fixed_frame == fixed_frame_;
  const CameraVelocity velocity = CameraVelocity::between(
      has_last_pose ? last_pose_ : *poses.fixed_from_optical, *poses.fixed_from_optical, seconds);
  fixed_frame_ = poses.fixed_frame;
  last_stamp_ = stamp;
  last_pose_ = *poses.fixed_from_optical;

  for (auto& [id, track] : tracks_) track.message.visible = false;
  for (const PublishedPlane& published : frame.published.planes) {
    if (published.id < kFirstUntrackedId) updateTrack(frame, published, seconds, velocity, parameters);
  }
  auto message = boost::make_shared<TrackedPlaneArray>();
  message->header.stamp = stamp;
  message->header.frame_id = fixed_frame_;
  removeHidden(stamp, tracking.track_memory);
  for (auto& [id, track] : tracks_) {
    if (!track.message.visible) {
      track.message.plane.label = 0;
      track.filter.predict(seconds, parameters);
      writeFilter(track.filter, track.message);
    }
    track.message.age = ros::Duration(stamp.toSec() - track.message.first_seen.toSec());
    message->planes.push_back(track.message);
  }
  return message;
}

}  // namespace line_plane_segmentation
