// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "renderer.h"

namespace line_plane_segmentation::simulation {

/// Noise model of the depth of a Kinect v1 or Xtion; each part can be switched off alone.
struct KinectNoiseParameters {
  /// Deviation of a measured depth, the paper's Eq. 5: in total, including quantisation.
  /// Zero `floor` and `growth` switch it off.
  NoiseParameters axial;

  double focal_length = 580.0;    ///< [px] of the infrared camera at its full resolution
  double baseline = 0.075;        ///< [m] distance from the infrared camera to the projector on its right
  double disparity_step = 0.125;  ///< [px] quantisation step of the disparity, 0: no quantisation

  double min_range = 0.45;  ///< [m] nearer pixels are invalid
  double max_range = 10.0;  ///< [m] farther pixels are invalid; at most 65.535

  bool projector_shadow = true;  ///< pixels that the projector does not light are missing

  /// [1/m] difference of inverse depth between neighbours from which they form a depth discontinuity: half
  /// a pixel of disparity.
  double edge_jump = 0.0115;
  double edge_dropout = 0.4;  ///< fraction of the pixels at depth edges that are missing

  /// [rad] angle between ray and normal from which pixels become invalid. Off if greater than pi / 2.
  double grazing_start = 1.36;
  double grazing_end = 1.50;  ///< [rad] angle from which all pixels are invalid
};

/// Turns a perfect depth image into that of a Kinect.
///
/// The depth is z = f b / disparity with the disparity quantised to 1/8 pixel, so depth levels are spaced
/// by z^2 step / (f b) = 0.00287 z^2 [m] (Khoshelham and Elberink, "Accuracy and resolution of Kinect depth
/// data for indoor mapping applications", Sensors 12, 2012: 2.85e-5 z^2 in centimetres). The measured error
/// of Eq. 5 includes the quantisation, so only the remaining variance is added before quantising.
///
/// The same rendering, seed and frame number give the same image, bit by bit, on every machine. Pixels are
/// independent of each other. Thread-safe.
class KinectNoise {
 public:
  /// @throw std::invalid_argument if a parameter is out of range
  explicit KinectNoise(const KinectNoiseParameters& parameters = {}, std::uint64_t seed = 1);

  /// @param intrinsics  of the rendering, valid
  /// @param frame  number of the frame; each number has its own noise
  /// @param depth_mm  [mm] output, width * height pixels, 0 = invalid (REP 118)
  void apply(const Rendering& rendering, const CameraIntrinsics& intrinsics, std::uint64_t frame,
             std::uint16_t* depth_mm) const;

 private:
  KinectNoiseParameters parameters_;
  std::uint64_t seed_;
};

}  // namespace line_plane_segmentation::simulation
