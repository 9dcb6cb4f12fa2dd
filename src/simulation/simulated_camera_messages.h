// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "renderer.h"

namespace line_plane_segmentation {

/// Returns a 16UC1 image of zeros in the host's byte order.
sensor_msgs::ImagePtr imageMessage(const std_msgs::Header& header, int width, int height);

/// Returns the pixels of a 16UC1 image in the host's byte order.
std::uint16_t* pixelsOf(sensor_msgs::Image& image);

/// Returns the labels of a rendering as a 16UC1 image.
sensor_msgs::ImagePtr labelsMessage(const std_msgs::Header& header, const simulation::Rendering& picture);

/// Returns the transform of a frame with this pose in `parent_frame`.
/// @param header  timestamp, and name of the frame
geometry_msgs::TransformStamped transformMessage(const Eigen::Isometry3d& pose,
                                                 const std_msgs::Header& header,
                                                 const std::string& parent_frame);

}  // namespace line_plane_segmentation
