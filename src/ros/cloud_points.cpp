// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_points.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <boost/endian/conversion.hpp>
#include <boost/make_shared.hpp>
#include <limits>

#include "line_plane_segmentation/palette.h"

namespace line_plane_segmentation {
namespace {

constexpr Color kNoPlane{150, 150, 150};

std::uint32_t packed(const Color& color) {
  return static_cast<std::uint32_t>(color.r) << 16 | static_cast<std::uint32_t>(color.g) << 8 | color.b;
}

// Colour, label and id for each label. Planes that are not published look like no plane.
std::vector<CloudPoint> pointsOfLabels(const SegmentedFrame& frame) {
  CloudPoint no_plane;
  no_plane.rgb = packed(kNoPlane);
  std::vector<CloudPoint> points(frame.segmentation.planes.size() + 1, no_plane);
  for (const PublishedPlane& published : frame.published.planes) {
    CloudPoint& point = points[published.plane.label];
    point.rgb = packed(colorOf(published.id));
    point.label = published.plane.label;
    point.id = published.id;
  }
  return points;
}

// x / z for each column, computed once for all rows.
std::vector<float> slopesOfColumns(const CameraIntrinsics& camera, int width) {
  std::vector<float> slopes(static_cast<std::size_t>(width));
  for (int u = 0; u < width; ++u) {
    slopes[u] = static_cast<float>((u - camera.cx) / camera.fx);
  }
  return slopes;
}

}  // namespace

sensor_msgs::PointCloud2::Ptr makeCloud(const SegmentedFrame& frame) {
  using sensor_msgs::PointField;
  auto cloud = boost::make_shared<sensor_msgs::PointCloud2>();
  cloud->header = frame.published.header;
  cloud->is_bigendian = boost::endian::order::native == boost::endian::order::big;
  sensor_msgs::PointCloud2Modifier modifier(*cloud);
  modifier.setPointCloud2Fields(6, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "rgb", 1, PointField::FLOAT32, "label", 1,
                                PointField::UINT32, "id", 1, PointField::UINT32);
  return cloud;
}

CloudRows::CloudRows(const SegmentedFrame& frame)
    : frame_(frame),
      rotation_(frame.published.target_from_optical.linear().cast<float>()),
      translation_(frame.published.target_from_optical.translation().cast<float>()),
      slopes_(slopesOfColumns(frame.camera, frame.segmentation.width)),
      of_label_(pointsOfLabels(frame)),
      depth_(slopes_.size()) {}

void CloudRows::load(int v) {
  loadRow(frame_.depth, v, frame_.range, depth_.data());
  // A pixel's point is z (slope_x, slope_y, 1), rotated and translated.
  const auto slope_y = static_cast<float>((v - frame_.camera.cy) / frame_.camera.fy);
  row_ = rotation_ * Eigen::Vector3f(0.0F, slope_y, 1.0F);
  labels_ = frame_.segmentation.labels.data() + static_cast<std::size_t>(v) * depth_.size();
}

CloudPoint CloudRows::point(std::size_t u) const {
  const float z = depth_[u] > 0.0F ? depth_[u] : std::numeric_limits<float>::quiet_NaN();
  const Eigen::Vector3f position = z * (slopes_[u] * rotation_.col(0) + row_) + translation_;
  CloudPoint point = of_label_[labels_[u]];
  point.x = position.x();
  point.y = position.y();
  point.z = position.z();
  return point;
}

}  // namespace line_plane_segmentation
