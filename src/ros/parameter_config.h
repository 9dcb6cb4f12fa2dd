// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneSegmenterConfig.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "location_parameters.h"
#include "robot_parameters.h"

namespace line_plane_segmentation {

/// Parameters that can be changed at run time.
struct NodeletParameters {
  std::string preset = "kinect";  ///< name of the preset that `method` is equal to, or "custom"
  Parameters method;
  LocationParameters location;
  RobotParameters robot;
};

/// Calls `visitor(name, value, min, max)` like visitParameters(), for all parameters except strings.
template <typename ParametersType, typename Visitor>
void visitNodeletParameters(ParametersType& p, Visitor&& visitor) {
  visitParameters(p.method, visitor);
  visitTrackingParameters(p.location.tracking, visitor);
  visitOrientationParameters(p.location.orientation, visitor);
  visitRobotParameters(p.robot, visitor);
  visitor("tf_patience", p.location.frames.tf_patience, 0.0, 1.0);
}

/// Calls `visitor(name, value)` for the frame parameters, which are strings.
template <typename ParametersType, typename Visitor>
void visitFrames(ParametersType& p, Visitor&& visitor) {
  visitor("target_frame", p.location.frames.target_frame);
  visitor("gravity_frame", p.location.frames.gravity_frame);
  visitor("fixed_frame", p.location.frames.fixed_frame);
}

/// Calls `visitor(name, value)` for all string parameters except the preset.
template <typename ParametersType, typename Visitor>
void visitTexts(ParametersType& p, Visitor&& visitor) {
  visitFrames(p, visitor);
  visitor("tf_fallback", p.location.frames.tf_fallback);
}

/// Returns the parameters of a dynamic_reconfigure config, matched by name.
NodeletParameters parametersFrom(const PlaneSegmenterConfig& config);

/// Writes the parameters into the config, matched by name.
void writeParameters(const NodeletParameters& parameters, PlaneSegmenterConfig& config);

/// Returns the parameters after a reconfigure request. NaN and unknown presets are refused and leave the
/// current value. Leading slashes of frames are removed. All other values are bounded by sanitize(). A new
/// preset sets all parameters of the method; other changes of the same request are applied after it.
/// `config` is set to the values in effect.
/// @param changes  one line is appended per value that was refused or changed
NodeletParameters reconfigured(const NodeletParameters& current, PlaneSegmenterConfig& config,
                               std::vector<std::string>& changes);

/// Checks the parameters that were set for this node handle before the start.
/// @throw std::invalid_argument that names each parameter of the wrong type or out of bounds
void checkParameterServer(const ros::NodeHandle& private_nh);

/// Completes the parameter server for dynamic_reconfigure: replaces the name of a method by its number and,
/// if the preset is not the default, sets the preset's parameters that are not set yet.
/// @pre checkParameterServer() has not thrown
/// @return the preset's name
std::string expandPreset(const ros::NodeHandle& private_nh);

}  // namespace line_plane_segmentation
