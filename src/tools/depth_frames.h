// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "image_file.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/depth_view.h"

namespace line_plane_segmentation {

/// One depth image of a recording, and the data for reading metres from it.
struct DepthFrame {
  std::string name;  ///< first part of the names of its results
  std::filesystem::path image;
  CameraIntrinsics camera;
  double depth_unit = 0.001;                    ///< [m] depth of one count
  int width = 0;                                ///< [px] of the image; 0: any
  int height = 0;                               ///< [px]
  bool largest_is_none = false;                 ///< 65535 in the image means no depth, as 0 does
  std::int64_t max_pixels = kDefaultMaxPixels;  ///< larger images are refused
};

/// The extensions of files that are read as depth images, ".png" first.
const std::vector<std::string>& depthFormats();

/// Reads "FX,FY,CX,CY" [px].
/// @throws BadInput unless these are four numbers that make a camera
CameraIntrinsics parseCamera(const std::string& text);

/// The frames of images that share one camera, each named after its file without the extension.
/// @throws BadInput if the depth unit is not a positive number
std::vector<DepthFrame> framesOfImages(const std::vector<std::string>& images, const CameraIntrinsics& camera,
                                       double depth_unit);

/// The frames of a table (CSV as RFC 4180: cells may be quoted, "" is a quote; a byte order mark is skipped)
/// with the columns frame, width, height, depth_unit or units_per_metre, fx, fy, cx, cy; other columns are
/// ignored. The images are depth/FRAME.png beside the table, or, where that does not exist, depth/FRAME with
/// another extension of depthFormats().
/// @throws BadInput if the table cannot be read, or says something that cannot be
std::vector<DepthFrame> framesOfTable(const std::filesystem::path& table);

/// @throws BadInput if there is no frame, or two have the same name
void checkNames(const std::vector<DepthFrame>& frames);

/// Decodes the frame's image from the content of its file.
/// @return CV_16UC1 or CV_32FC1
/// @throws BadInput if it cannot be decoded or has another size than the frame states
cv::Mat decodeDepth(const std::vector<unsigned char>& bytes, const DepthFrame& frame);

/// A view of a depth image as decodeDepth() returns it, which has to outlive the view.
DepthView depthViewOf(const cv::Mat& depth, double depth_unit);

/// Reads and decodes the frame's image.
/// @throws BadInput if it cannot be read, or as decodeDepth()
cv::Mat readDepth(const DepthFrame& frame);

}  // namespace line_plane_segmentation
