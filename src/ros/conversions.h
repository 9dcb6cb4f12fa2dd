// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"
#include "line_plane_segmentation/segmentation.h"
#include "published_planes.h"

namespace line_plane_segmentation {

/// A segmented depth image with the data from which its messages are built. Owns nothing.
struct SegmentedFrame {
  const std_msgs::Header& header;  ///< header of image messages: timestamp and frame of the depth image
  const DepthView& depth;
  const DepthRange& range;  ///< [m] range of valid depths
  const CameraIntrinsics& camera;
  const Segmentation& segmentation;
  const PublishedPlanes& published;  ///< planes to publish, and the header of all other messages
  double processing_time = 0.0;      ///< [ms] duration of the segmentation
};

/// Returns the message of all planes. All values are finite.
PlaneArray::Ptr planesMessage(const SegmentedFrame& frame);

/// Returns the label image, 16UC1: 0 = no published plane, k = plane with label k.
sensor_msgs::Image::Ptr labelsImage(const SegmentedFrame& frame);

/// Returns an organised XYZRGB cloud, one point per pixel, in the colours of the planes' ids, grey without
/// a plane. x, y and z of invalid pixels are NaN (REP 117); no other message contains NaN.
sensor_msgs::PointCloud2::Ptr coloredCloud(const SegmentedFrame& frame);

/// Returns an rgb8 image: depth as grey, near is light, tinted with the colours of the planes' ids.
sensor_msgs::Image::Ptr overlayImage(const SegmentedFrame& frame);

/// Returns markers for rviz: a DELETEALL, and for each plane its outlines with holes (namespace "outlines"),
/// an arrow along its normal ("normals") and its id, area and, if known, orientation ("ids"). Arrow and text
/// are placed at a visible point of the plane.
visualization_msgs::MarkerArray::Ptr planeMarkers(const SegmentedFrame& frame);

/// Returns markers for rviz of intermediate results, as in Figure 4 of the paper: a DELETEALL, the line
/// segments along rows ("rows") and columns ("columns") of the image, and the candidates' normals
/// ("candidates").
/// @param segments, candidates  of this frame
visualization_msgs::MarkerArray::Ptr scanlineMarkers(const SegmentedFrame& frame,
                                                     const std::vector<LineSegment>& segments,
                                                     const std::vector<PlaneCandidate>& candidates);

}  // namespace line_plane_segmentation
