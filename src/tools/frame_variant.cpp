// SPDX-License-Identifier: BSD-3-Clause
#include "frame_variant.h"

#include <utility>

#include "region_overlap.h"

namespace line_plane_segmentation {
namespace {

constexpr Orientation kOrientations[] = {Orientation::kUpright, Orientation::kMirrored,
                                         Orientation::kQuarterTurn, Orientation::kHalfTurn};
constexpr double kDefaultSpacing = 12.0;  // [px] at VGA, to which the spacings of the variants refer

// OpenCV's code for cv::flip() around the vertical axis.
constexpr int kLeftRight = 1;

CameraIntrinsics turned(const CameraIntrinsics& camera, const cv::Size& size, Orientation orientation) {
  const double cx_from_right = size.width - 1 - camera.cx, cy_from_bottom = size.height - 1 - camera.cy;
  switch (orientation) {
    case Orientation::kMirrored:
      return {camera.fx, camera.fy, cx_from_right, camera.cy};
    case Orientation::kQuarterTurn:
      return {camera.fy, camera.fx, cy_from_bottom, camera.cx};
    case Orientation::kHalfTurn:
      return {camera.fx, camera.fy, cx_from_right, cy_from_bottom};
    case Orientation::kUpright:
      break;
  }
  return camera;
}

cv::Mat turned(const cv::Mat& image, Orientation orientation) {
  cv::Mat result;
  switch (orientation) {
    case Orientation::kMirrored:
      cv::flip(image, result, kLeftRight);
      return result;
    case Orientation::kQuarterTurn:
      cv::rotate(image, result, cv::ROTATE_90_CLOCKWISE);
      return result;
    case Orientation::kHalfTurn:
      cv::rotate(image, result, cv::ROTATE_180);
      return result;
    case Orientation::kUpright:
      break;
  }
  return image;
}

cv::Mat shifted(const cv::Mat& image, int pixels, std::uint16_t border) {
  cv::Mat result;
  cv::copyMakeBorder(image, result, pixels, 0, pixels, 0, cv::BORDER_CONSTANT, cv::Scalar(border));
  return result;
}

}  // namespace

std::vector<FrameVariant> allVariants() {
  std::vector<FrameVariant> variants;
  for (const Orientation orientation : kOrientations) {
    for (const int spacing : {10, 11, 12, 13, 14}) {
      for (const bool is_shifted : {false, true}) {
        variants.push_back({orientation, spacing / kDefaultSpacing, is_shifted});
      }
    }
  }
  return variants;
}

std::vector<FrameVariant> fewVariants() {
  std::vector<FrameVariant> variants;
  for (const Orientation orientation : kOrientations) {
    variants.push_back({orientation, 11 / kDefaultSpacing, false});
    variants.push_back({orientation, 13 / kDefaultSpacing, true});
  }
  return variants;
}

std::vector<FrameVariant> uprightVariants() {
  std::vector<FrameVariant> variants;
  for (const int spacing : {10, 12, 14}) {
    for (const bool is_shifted : {false, true}) {
      variants.push_back({Orientation::kUpright, spacing / kDefaultSpacing, is_shifted});
    }
  }
  return variants;
}

LabelledFrame turned(const LabelledFrame& frame, Orientation orientation) {
  LabelledFrame result = frame;
  result.depth = turned(frame.depth, orientation);
  result.truth = turned(frame.truth, orientation);
  result.camera = turned(frame.camera, frame.depth.size(), orientation);
  return result;
}

LabelledFrame shifted(const LabelledFrame& frame, int pixels) {
  LabelledFrame result = frame;
  result.depth = shifted(frame.depth, pixels, 0);
  result.truth = shifted(frame.truth, pixels, kDoNotJudge);
  result.camera.cx += pixels;
  result.camera.cy += pixels;
  return result;
}

}  // namespace line_plane_segmentation
