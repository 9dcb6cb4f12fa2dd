// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

namespace line_plane_segmentation {
namespace {

// Queue sizes for slow connections: several small messages, but only the newest large one.
constexpr unsigned kSmallMessages = 10;
constexpr unsigned kLargeMessages = 2;

bool wantedBySomebody(const ros::Publisher& publisher) { return publisher.getNumSubscribers() > 0; }

template <typename MakeMessage>
void publishIfWanted(const ros::Publisher& publisher, const SegmentedFrame& frame, MakeMessage makeMessage) {
  if (wantedBySomebody(publisher)) publisher.publish(makeMessage(frame));
}

}  // namespace

Outputs::Outputs(ros::NodeHandle private_nh, const std::function<void()>& subscribers_changed) {
  const ros::SubscriberStatusCallback changed = [subscribers_changed](const ros::SingleSubscriberPublisher&) {
    subscribers_changed();
  };
  planes_ = private_nh.advertise<PlaneArray>("planes", kSmallMessages, changed, changed);
  labels_ = private_nh.advertise<sensor_msgs::Image>("labels", kLargeMessages, changed, changed);
  cloud_ = private_nh.advertise<sensor_msgs::PointCloud2>("cloud", kLargeMessages, changed, changed);
  overlay_ = private_nh.advertise<sensor_msgs::Image>("overlay", kLargeMessages, changed, changed);
  markers_ =
      private_nh.advertise<visualization_msgs::MarkerArray>("markers", kLargeMessages, changed, changed);
  scanlines_ =
      private_nh.advertise<visualization_msgs::MarkerArray>("scanlines", kLargeMessages, changed, changed);
  cloud_without_planes_ = private_nh.advertise<sensor_msgs::PointCloud2>("cloud_without_planes",
                                                                         kLargeMessages, changed, changed);
  objects_ = private_nh.advertise<SupportedObjectArray>("objects", kSmallMessages, changed, changed);
  tracked_planes_ =
      private_nh.advertise<TrackedPlaneArray>("tracked_planes", kSmallMessages, changed, changed);
}

bool Outputs::wanted() const {
  for (const ros::Publisher* publisher : {&planes_, &labels_, &cloud_, &overlay_, &markers_, &scanlines_,
                                          &cloud_without_planes_, &objects_, &tracked_planes_}) {
    if (wantedBySomebody(*publisher)) return true;
  }
  return false;
}

bool Outputs::outlinesWanted() const {
  return wantedBySomebody(planes_) || wantedBySomebody(markers_) || wantedBySomebody(tracked_planes_);
}

bool Outputs::scanlinesWanted() const { return wantedBySomebody(scanlines_); }

void Outputs::publish(const SegmentedFrame& frame, RobotMessages& robot) const {
  publishIfWanted(planes_, frame, planesMessage);
  publishIfWanted(labels_, frame, labelsImage);
  publishIfWanted(cloud_, frame, coloredCloud);
  publishIfWanted(overlay_, frame, overlayImage);
  robot.start(frame);
  if (wantedBySomebody(cloud_without_planes_)) cloud_without_planes_.publish(robot.cloudWithoutPlanes());
  if (wantedBySomebody(objects_)) objects_.publish(robot.objects());
  if (wantedBySomebody(tracked_planes_)) {
    if (const TrackedPlaneArray::Ptr message = robot.trackedPlanes()) tracked_planes_.publish(message);
  }
  if (wantedBySomebody(markers_)) {
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
