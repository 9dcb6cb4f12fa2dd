// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "line_plane_segmentation/simulation/simulated_camera.h"

namespace line_plane_segmentation {

/// The simulated camera's settings at the start. Names on the parameter server: `~seed`, `~width`,
/// `~height` (default: three quarters of the width), `~noise`, and the members below.
struct SimulatedCameraParameters {
  simulation::SimulatedCamera::Options camera;
  double rate = 30.0;                                   ///< [Hz] above 0, at most 1000
  std::string frame_id = "camera_depth_optical_frame";  ///< of the images; must not be empty
  std::string world_frame = "world";                    ///< z up; must not be empty
  bool publish_tf = true;                               ///< the pose of `frame_id` in `world_frame`
};

/// @throw std::invalid_argument  naming the parameter that has a wrong type or value
SimulatedCameraParameters readParameters(const ros::NodeHandle& private_nh);

}  // namespace line_plane_segmentation
