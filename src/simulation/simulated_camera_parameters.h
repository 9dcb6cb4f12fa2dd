// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "simulated_camera.h"

namespace line_plane_segmentation {

/// Start parameters of the simulated camera. Names on the parameter server: `~seed`, `~width`,
/// `~height` (default: three quarters of the width), `~noise`, and the members below.
struct SimulatedCameraParameters {
  simulation::SimulatedCamera::Options camera;
  double rate = 30.0;                                   ///< [Hz] above 0, at most 1000
  std::string frame_id = "camera_depth_optical_frame";  ///< frame_id of the images, not empty
  std::string world_frame = "world";                    ///< frame with z up, not empty
  bool publish_tf = true;                               ///< publish the pose of `frame_id` in `world_frame`
};

/// @throw std::invalid_argument  naming the parameter that has a wrong type or value
SimulatedCameraParameters readParameters(const ros::NodeHandle& private_nh);

}  // namespace line_plane_segmentation
