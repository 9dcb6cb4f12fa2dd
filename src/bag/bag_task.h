// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/stream.h>

#include <filesystem>

#include "depth_topics.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/ros/image_validation.h"
#include "line_plane_segmentation/ros/location_parameters.h"

namespace line_plane_segmentation {

/// What to do with a bag.
struct BagTask {
  std::filesystem::path in;
  std::filesystem::path out;
  std::filesystem::path csv;  ///< table of the planes; empty: none
  TopicChoice topics;         ///< the depth images, and where their intrinsics come from
  InputLimits limits;
  Parameters parameters;
  LocationParameters location;

  // What is written besides the planes.
  bool labels = false;
  bool cloud = false;
  bool overlay = false;
  bool markers = false;
  bool scanlines = false;
  bool input = false;  ///< every message of `in`

  rosbag::CompressionType compression = rosbag::compression::LZ4;
};

/// Segments the depth images of a bag into another one, which appears whole or not at all, and says on stdout
/// what was done, on stderr how far it is.
/// @throws BadInput if nothing could be done, or, once `out` is there, if a part of `in` could not be read or
/// none of
///         its transforms lead to a frame of the parameters
void segmentBag(const BagTask& task);

}  // namespace line_plane_segmentation
