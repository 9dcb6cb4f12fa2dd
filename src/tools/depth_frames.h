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

/// Depth image file with the data for converting it to metres.
struct DepthFrame {
  std::string name;  ///< prefix of the names of its results
  std::filesystem::path image;
  CameraIntrinsics camera;
  double depth_unit = 0.001;                    ///< [m] depth of one count
  int width = 0;                                ///< [px] expected size of the image; 0: any
  int height = 0;                               ///< [px]
  bool largest_is_none = false;                 ///< true if 65535 is an invalid depth, as 0 is
  std::int64_t max_pixels = kDefaultMaxPixels;  ///< larger images are refused
};

/// Returns the file name extensions of depth images, ".png" first.
const std::vector<std::string>& depthFormats();

/// Reads "FX,FY,CX,CY" [px].
/// @throws BadInput unless these are four numbers that make a camera
CameraIntrinsics parseCamera(const std::string& text);

/// Returns frames of images with a common camera. The name of a frame is its file name without the extension.
/// @throws BadInput if the depth unit is not a positive number
std::vector<DepthFrame> framesOfImages(const std::vector<std::string>& images, const CameraIntrinsics& camera,
                                       double depth_unit);

/// Reads the frames of a table: CSV as in RFC 4180, with the columns frame, width, height, depth_unit or
/// units_per_metre, fx, fy, cx, cy. Other columns and a byte order mark are ignored. The images are
/// depth/FRAME.png beside the table or, if that does not exist, depth/FRAME with another extension of
/// depthFormats().
/// @throws BadInput if the table cannot be read or a value is invalid
std::vector<DepthFrame> framesOfTable(const std::filesystem::path& table);

/// Checks that there is at least one frame, and that all names differ.
/// @throws BadInput otherwise
void checkNames(const std::vector<DepthFrame>& frames);

/// Decodes the frame's image from the content of its file.
/// @return CV_16UC1 or CV_32FC1
/// @throws BadInput if it cannot be decoded or has another size than the frame states
cv::Mat decodeDepth(const std::vector<unsigned char>& bytes, const DepthFrame& frame);

/// Returns a view of a result of decodeDepth(), which must outlive the view.
DepthView depthViewOf(const cv::Mat& depth, double depth_unit);

/// Reads and decodes the frame's image.
/// @throws BadInput if it cannot be read, or as decodeDepth()
cv::Mat readDepth(const DepthFrame& frame);

}  // namespace line_plane_segmentation
