// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "info_matcher.h"
#include "line_plane_segmentation/ros/image_validation.h"
#include "rectify.h"

namespace line_plane_segmentation {

/// What is set before the nodelet starts, and stays.
struct StartParameters {
  bool clouds = false;  ///< reads point clouds in the place of images
  int queue_size = 10;  ///< messages that wait at most
  InfoMatching info_matching = InfoMatching::kAuto;
  Rectify rectify = Rectify::kAuto;
  InputLimits limits;
};

/// Reads them, and looks at diagnostic_period, which is diagnostic_updater's own.
/// @throw std::invalid_argument that names the first one of the wrong type or out of bounds
StartParameters readStartParameters(const ros::NodeHandle& private_nh);

/// The names of the start parameters.
std::vector<std::string> startParameterNames();

/// Deletes a diagnostic_period that diagnostic_updater could not work with.
void dropBadDiagnosticPeriod(const ros::NodeHandle& private_nh);

}  // namespace line_plane_segmentation
