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
#include "line_plane_segmentation/line_segment.h"
#include "line_plane_segmentation/plane_candidate.h"
#include "line_plane_segmentation/ros/published_planes.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// A segmented depth image and all that its messages are made from. Owns none of it.
struct SegmentedFrame {
  const std_msgs::Header& header;  ///< of the images: the depth image's stamp and frame
  const DepthView& depth;
  const DepthRange& range;  ///< [m] that was looked at
  const CameraIntrinsics& camera;
  const Segmentation& segmentation;
  const PublishedPlanes& published;  ///< what is told of its planes, and the header of everything else
  double processing_time = 0.0;      ///< [ms] that the segmentation took
};

/// Everything about the planes, in one message. Every number is finite.
PlaneArray::Ptr planesMessage(const SegmentedFrame& frame);

/// 16UC1: 0 no plane that is published, k the plane with label k.
sensor_msgs::Image::Ptr labelsImage(const SegmentedFrame& frame);

/// Organised XYZRGB, a point for each pixel, in the colours of the planes' ids, grey without a plane.
/// Where there is no depth x, y and z are NaN (REP 117), the only messages' numbers that ever are.
sensor_msgs::PointCloud2::Ptr coloredCloud(const SegmentedFrame& frame);

/// rgb8: the depth as grey, near is light, tinted with the colours of the planes' ids.
sensor_msgs::Image::Ptr overlayImage(const SegmentedFrame& frame);

/// For rviz: a DELETEALL, and for each plane its outlines with holes (namespace "outlines"), an arrow
/// along its normal ("normals") and its id, area and orientation, where that is known ("ids"). Arrow and text
/// stand where the camera sees the plane.
visualization_msgs::MarkerArray::Ptr planeMarkers(const SegmentedFrame& frame);

/// For rviz, the method at work, as the paper's Figure 4 shows it: a DELETEALL, the line segments along rows
/// ("rows") and columns ("columns") of the image, and the candidates' normals ("candidates").
/// @param segments, candidates  of this frame
visualization_msgs::MarkerArray::Ptr scanlineMarkers(const SegmentedFrame& frame,
                                                     const std::vector<LineSegment>& segments,
                                                     const std::vector<PlaneCandidate>& candidates);

}  // namespace line_plane_segmentation
