// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

namespace line_plane_segmentation {
namespace {

// Queue size for slow connections: only the newest large message.
constexpr unsigned kLargeMessages = 2;

bool hasSubscribers(const ros::Publisher& publisher) { return publisher.getNumSubscribers() > 0; }

template <typename MakeMessage>
void publishIfSubscribed(const ros::Publisher& publisher, const SegmentedFrame& frame,
                         MakeMessage make_message) {
  if (hasSubscribers(publisher)) publisher.publish(make_message(frame));
}

}  // namespace

Outputs::Outputs(ros::NodeHandle private_nh, unsigned queue_size,
                 const std::function<void()>& subscribers_changed) {
  const ros::SubscriberStatusCallback changed = [subscribers_changed](const ros::SingleSubscriberPublisher&) {
    subscribers_changed();
  };
  planes_ = private_nh.advertise<PlaneArray>("planes", queue_size, changed, changed);
  labels_ = private_nh.advertise<sensor_msgs::Image>("labels", kLargeMessages, changed, changed);
  cloud_ = private_nh.advertise<sensor_msgs::PointCloud2>("cloud", kLargeMessages, changed, changed);
  overlay_ = private_nh.advertise<sensor_msgs::Image>("overlay", kLargeMessages, changed, changed);
  markers_ =
      private_nh.advertise<visualization_msgs::MarkerArray>("markers", kLargeMessages, changed, changed);
  scanlines_ =
      private_nh.advertise<visualization_msgs::MarkerArray>("scanlines", kLargeMessages, changed, changed);
  cloud_without_planes_ = private_nh.advertise<sensor_msgs::PointCloud2>("cloud_without_planes",
                                                                         kLargeMessages, changed, changed);
  objects_ = private_nh.advertise<SupportedObjectArray>("objects", queue_size, changed, changed);
  tracked_planes_ = private_nh.advertise<TrackedPlaneArray>("tracked_planes", queue_size, changed, changed);
}

bool Outputs::subscribed() const {
  for (const ros::Publisher* publisher : {&planes_, &labels_, &cloud_, &overlay_, &markers_, &scanlines_,
                                          &cloud_without_planes_, &objects_, &tracked_planes_}) {
    if (hasSubscribers(*publisher)) return true;
  }
  return false;
}

bool Outputs::needsOutlines() const {
  return hasSubscribers(planes_) || hasSubscribers(markers_) || hasSubscribers(tracked_planes_);
}

bool Outputs::needsScanlines() const { return hasSubscribers(scanlines_); }

void Outputs::publish(const SegmentedFrame& frame, RobotMessages& robot) const {
  publishIfSubscribed(planes_, frame, planesMessage);
  publishIfSubscribed(labels_, frame, labelsImage);
  publishIfSubscribed(cloud_, frame, coloredCloud);
  publishIfSubscribed(overlay_, frame, overlayImage);
  robot.setFrame(frame);
  if (hasSubscribers(cloud_without_planes_)) cloud_without_planes_.publish(robot.cloudWithoutPlanes());
  if (hasSubscribers(objects_)) objects_.publish(robot.objects());
  if (hasSubscribers(tracked_planes_)) {
    if (const TrackedPlaneArray::Ptr message = robot.trackedPlanes()) tracked_planes_.publish(message);
  }
  if (hasSubscribers(markers_)) {
    const visualization_msgs::MarkerArray::Ptr message = planeMarkers(frame);
    robot.addObjectMarkers(*message);
    markers_.publish(message);
  }
}

void Outputs::publishScanlines(const SegmentedFrame& frame, const std::vector<LineSegment>& segments,
                               const std::vector<PlaneCandidate>& candidates) const {
  scanlines_.publish(scanlineMarkers(frame, segments, candidates));
}

}  // namespace line_plane_segmentation
