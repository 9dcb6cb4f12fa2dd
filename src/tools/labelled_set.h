// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// One depth image with the ground truth of its planes.
struct LabelledFrame {
  std::string name;
  cv::Mat depth;  ///< CV_16UC1, 0 = invalid depth
  cv::Mat truth;  ///< CV_16UC1 of the same size: 0 = no plane, k = plane k, 65535 = excluded
  CameraIntrinsics camera;
  double depth_unit = 0.001;  ///< [m] depth of one count

  const std::uint16_t* depthPixels() const { return depth.ptr<std::uint16_t>(); }
  const std::uint16_t* truthPixels() const { return truth.ptr<std::uint16_t>(); }
};

/// Selects frames by their index in the table, which starts at 0.
enum class Half { kBoth, kEven, kOdd };

/// Reads the frames of a labelled set: FOLDER/frames.csv, FOLDER/depth/FRAME.png and FOLDER/truth/FRAME.png.
/// @throws BadInput if the table or an image cannot be read, two images differ in size, or no frame is
/// selected
std::vector<LabelledFrame> readLabelledSet(const std::filesystem::path& folder, Half half = Half::kBoth);

}  // namespace line_plane_segmentation
