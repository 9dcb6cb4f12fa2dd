// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/stream.h>

#include <filesystem>

#include "depth_topics.h"
#include "image_validation.h"
#include "line_plane_segmentation/parameters.h"
#include "location_parameters.h"

namespace line_plane_segmentation {

/// Options of segment_bag.
struct BagTask {
  std::filesystem::path in;
  std::filesystem::path out;
  std::filesystem::path csv;  ///< file of the table of planes; empty: none
  TopicChoice topics;         ///< topics of the depth images and of their intrinsics
  InputLimits limits;
  Parameters parameters;
  LocationParameters location;

  // Outputs besides the planes.
  bool labels = false;
  bool cloud = false;
  bool overlay = false;
  bool markers = false;
  bool scanlines = false;
  bool input = false;  ///< copies of all messages of `in`

  rosbag::CompressionType compression = rosbag::compression::LZ4;
};

/// Segments the depth images of a bag and writes the results to another bag, which appears complete or not
/// at all. Prints a summary on stdout and the progress on stderr.
/// @throws BadInput if no image was segmented; or, after `out` is written, if a part of `in` was unreadable
/// or
///         a frame of the parameters is not connected to the camera by any transform
void segmentBag(const BagTask& task);

}  // namespace line_plane_segmentation
