// SPDX-License-Identifier: BSD-3-Clause
#include "objects_message.h"

#include <boost/make_shared.hpp>
#include <cstdint>

#include "marker_tools.h"

namespace line_plane_segmentation {
namespace {

using visualization_msgs::Marker;

geometry_msgs::Pose poseOf(const Eigen::Isometry3d& transform) {
  const Eigen::Quaterniond rotation(transform.linear());
  geometry_msgs::Pose pose;
  pose.position = pointOf(transform.translation());
  pose.orientation.w = rotation.w();
  pose.orientation.x = rotation.x();
  pose.orientation.y = rotation.y();
  pose.orientation.z = rotation.z();
  return pose;
}

// id of each plane by label, 0 if it is not published.
std::vector<std::uint32_t> idsOfLabels(const SegmentedFrame& frame) {
  std::vector<std::uint32_t> ids(frame.segmentation.planes.size() + 1, 0);
  for (const PublishedPlane& published : frame.published.planes) ids[published.plane.label] = published.id;
  return ids;
}

}  // namespace

std::vector<std::size_t> supportsOf(const SegmentedFrame& frame) {
  std::vector<std::size_t> supports;
  for (const PublishedPlane& published : frame.published.planes) {
    if (published.orientation == Orientation::kHorizontalUp) {
      supports.push_back(published.plane.label - std::size_t{1});
    }
  }
  return supports;
}

SupportedObjectArray::Ptr objectsMessage(const SegmentedFrame& frame,
                                         const std::vector<DetectedObject>& objects,
                                         const std::vector<std::size_t>& supports) {
  const std::vector<std::uint32_t> ids = idsOfLabels(frame);
  const std::vector<SegmentedPlane>& planes = frame.segmentation.planes;
  auto message = boost::make_shared<SupportedObjectArray>();
  message->header = frame.published.header;
  for (const std::size_t support : supports) message->support_ids.push_back(ids[planes[support].label]);
  for (const DetectedObject& object : objects) {
    SupportedObject out;
    out.support_label = planes[object.support].label;
    out.support_id = ids[out.support_label];
    out.centroid = pointOf((frame.published.target_from_optical * object.centroid).eval());
    out.box_pose = poseOf(frame.published.target_from_optical * object.box);
    out.box_size.x = object.size.x();
    out.box_size.y = object.size.y();
    out.box_size.z = object.size.z();
    out.pixels = object.pixels;
    out.first_column = static_cast<std::uint32_t>(object.first_column);
    out.first_row = static_cast<std::uint32_t>(object.first_row);
    out.columns = static_cast<std::uint32_t>(object.columns);
    out.rows = static_cast<std::uint32_t>(object.rows);
    message->objects.push_back(out);
  }
  return message;
}

void addObjectMarkers(const SegmentedFrame& frame, const std::vector<DetectedObject>& objects,
                      visualization_msgs::MarkerArray& markers) {
  constexpr float kAlpha = 0.5F;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const DetectedObject& object = objects[i];
    const auto number = static_cast<std::uint32_t>(i + 1);
    Marker marker = makeMarker(frame.published.header, "objects", number, Marker::CUBE);
    marker.color = toRgba(colorOf(number));
    marker.color.a = kAlpha;
    marker.pose = poseOf(frame.published.target_from_optical * object.box);
    marker.scale.x = object.size.x();
    marker.scale.y = object.size.y();
    marker.scale.z = object.size.z();
    markers.markers.push_back(marker);
  }
}

}  // namespace line_plane_segmentation
