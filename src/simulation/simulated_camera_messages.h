// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "line_plane_segmentation/simulation/renderer.h"

namespace line_plane_segmentation {

/// A 16UC1 image of zeros in this machine's byte order.
sensor_msgs::ImagePtr imageMessage(const std_msgs::Header& header, int width, int height);

/// The pixels of a 16UC1 image in this machine's byte order.
std::uint16_t* pixelsOf(sensor_msgs::Image& image);

/// The labels of an image, 16UC1.
sensor_msgs::ImagePtr labelsMessage(const std_msgs::Header& header, const simulation::Rendering& picture);

/// @param header  stamp, and the frame that has this pose in `parent_frame`
geometry_msgs::TransformStamped transformMessage(const Eigen::Isometry3d& pose,
                                                 const std_msgs::Header& header,
                                                 const std::string& parent_frame);

}  // namespace line_plane_segmentation
