// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "line_plane_segmentation/camera_intrinsics.h"

namespace line_plane_segmentation {

/// One depth image of a recording and what is needed to read metres from it.
struct DepthFrame {
  std::string name;  ///< what its results are called after
  std::filesystem::path image;
  CameraIntrinsics camera;
  double units_per_metre = 1000.0;
  int width = 0;                 ///< [px] what the image must have; 0 = whatever it has
  int height = 0;                ///< [px]
  bool largest_is_none = false;  ///< 65535 in the image says, as 0 does, that there is no depth
};

/// Reads "FX,FY,CX,CY" [px].
/// @throws BadInput unless these are four numbers that make a camera
CameraIntrinsics parseCamera(const std::string& text);

/// The frames of images that share one camera, each named after its file without the extension.
/// @throws BadInput if the depth scale is no positive number
std::vector<DepthFrame> framesOfImages(const std::vector<std::string>& images, const CameraIntrinsics& camera,
                                       double units_per_metre);

/// The frames of a table with the columns frame, width, height, units_per_metre, fx, fy, cx, cy (others
/// are passed over), whose images are depth/FRAME.png beside the table.
/// @throws BadInput if the table cannot be read, or says something that cannot be
std::vector<DepthFrame> framesOfTable(const std::filesystem::path& table);

/// @throws BadInput if there is no frame, or two share a name
void checkNames(const std::vector<DepthFrame>& frames);

/// Reads the frame's image, 16 bits a pixel.
/// @throws BadInput if it cannot be read or is not as the frame says
cv::Mat readDepth(const DepthFrame& frame);

}  // namespace line_plane_segmentation
