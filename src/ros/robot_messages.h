// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "objects_message.h"
#include "obstacle_cloud.h"
#include "robot_parameters.h"
#include "tracked_planes.h"

namespace line_plane_segmentation {

/// Builds the messages for robots: obstacle cloud, objects, fused planes. Each is computed on request,
/// objects once per frame. Not thread-safe.
class RobotMessages {
 public:
  /// @param name  name of the nodelet, for the log
  explicit RobotMessages(const std::string& name) : name_(name) {}

  void setParameters(const RobotParameters& robot, const NoiseParameters& noise,
                     const TrackingParameters& tracking);

  /// Selects the frame of the calls below. It must stay valid until the next call of setFrame().
  void setFrame(const SegmentedFrame& frame);

  sensor_msgs::PointCloud2::Ptr cloudWithoutPlanes() const;
  SupportedObjectArray::Ptr objects();
  void addObjectMarkers(visualization_msgs::MarkerArray& markers);

  /// Fuses the frame's planes.
  /// @return null if the camera's pose in the fixed frame is unknown
  TrackedPlaneArray::Ptr trackedPlanes();

 private:
  const std::vector<DetectedObject>& detectedObjects();

  std::string name_;
  RobotParameters robot_;
  NoiseParameters noise_;
  TrackingParameters tracking_;
  const SegmentedFrame* frame_ = nullptr;
  ObjectDetector detector_;
  const std::vector<DetectedObject>* objects_ = nullptr;  // objects of this frame; null until detectedObjects
  TrackedPlanes tracked_planes_;
};

}  // namespace line_plane_segmentation
