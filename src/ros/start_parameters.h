// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "image_validation.h"
#include "info_matcher.h"
#include "rectification_mode.h"

namespace line_plane_segmentation {

/// Parameters that are read once, when the nodelet starts.
struct StartParameters {
  bool clouds = false;  ///< subscribe to a point cloud instead of images
  int queue_size = 10;  ///< largest number of waiting messages, in and out
  InfoMatching info_matching = InfoMatching::kAuto;
  RectificationMode rectify = RectificationMode::kAuto;
  InputLimits limits;
};

/// Reads the start parameters, and checks diagnostic_period, which diagnostic_updater reads itself.
/// @throw std::invalid_argument with the name of the first parameter of the wrong type or out of bounds
StartParameters readStartParameters(const ros::NodeHandle& private_nh);

/// Returns the names of the start parameters.
std::vector<std::string> startParameterNames();

/// Deletes diagnostic_period from the parameter server if diagnostic_updater cannot use its value.
void removeInvalidDiagnosticPeriod(const ros::NodeHandle& private_nh);

}  // namespace line_plane_segmentation
