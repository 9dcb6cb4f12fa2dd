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
}

bool Outputs::wanted() const {
  for (const ros::Publisher* publisher : {&planes_, &labels_, &cloud_, &overlay_, &markers_, &scanlines_}) {
    if (wantedBySomebody(*publisher)) return true;
  }
  return false;
}

bool Outputs::outlinesWanted() const { return wantedBySomebody(planes_) || wantedBySomebody(markers_); }

bool Outputs::scanlinesWanted() const { return wantedBySomebody(scanlines_); }

void Outputs::publish(const SegmentedFrame& frame) const {
  publishIfWanted(planes_, frame, planesMessage);
  publishIfWanted(labels_, frame, labelsImage);
  publishIfWanted(cloud_, frame, coloredCloud);
  publishIfWanted(overlay_, frame, overlayImage);
  publishIfWanted(markers_, frame, planeMarkers);
}

void Outputs::publishScanlines(const SegmentedFrame& frame, const std::vector<LineSegment>& segments,
                               const std::vector<PlaneCandidate>& candidates) const {
  scanlines_.publish(scanlineMarkers(frame, segments, candidates));
}

}  // namespace line_plane_segmentation
