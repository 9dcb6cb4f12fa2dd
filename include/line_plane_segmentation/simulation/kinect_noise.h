// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/simulation/renderer.h"

namespace line_plane_segmentation::simulation {

/// Noise model of the depth of a Kinect v1 or Xtion; each part can be switched off alone.
struct KinectNoiseParameters {
  /// Deviation of a measured depth, the paper's Eq. 5: in total, including quantisation.
  /// Zero `floor` and `growth` switch it off.
  NoiseParameters axial;

  double focal_length = 580.0;    ///< [px] of the infrared camera at its full resolution
  double baseline = 0.075;        ///< [m] from the infrared camera to the projector on its right
  double disparity_step = 0.125;  ///< [px] smallest difference of disparity; 0 = no quantisation

  double min_range = 0.45;  ///< [m] nearer pixels are missing
  double max_range = 10.0;  ///< [m] farther pixels are missing, at most 65.535

  bool projector_shadow = true;  ///< pixels that the projector does not light are missing

  /// [1/m] difference of inverse depth between neighbours that counts as a depth edge: half a pixel of
  /// disparity.
  double edge_jump = 0.0115;
  double edge_dropout = 0.4;  ///< fraction of the pixels at depth edges that are missing

  /// [rad] angle of the ray to the plane's normal where pixels start to go missing, and where all are; a
  /// start over pi / 2 switches it off.
  double grazing_start = 1.36;
  double grazing_end = 1.50;
};

/// Turns a perfect depth image into that of a Kinect.
///
/// A depth is z = f b / disparity, and disparity comes in steps of 1/8 pixel, so depths come in levels
/// with gaps of z^2 step / (f b) = 0.00287 z^2 [m] (Khoshelham and Elberink, "Accuracy and resolution of
/// Kinect depth data for indoor mapping applications", Sensors 12, 2012: 2.85e-5 z^2 in centimetres). The
/// error of Eq. 5 was measured with the quantisation in it, so only the rest of its variance is added before.
///
/// The same rendering, seed and frame number give the same image, bit by bit, on every machine. Pixels are
/// independent of each other. Thread-safe.
class KinectNoise {
 public:
  /// @throw std::invalid_argument  if a parameter is out of its range
  explicit KinectNoise(const KinectNoiseParameters& parameters = {}, std::uint64_t seed = 1);

  /// @param intrinsics  of the rendering, valid
  /// @param frame       number of the frame: other numbers, other noise
  /// @param depth_mm    [mm] width * height pixels, 0 = no depth (REP 118)
  void apply(const Rendering& rendering, const CameraIntrinsics& intrinsics, std::uint64_t frame,
             std::uint16_t* depth_mm) const;

 private:
  KinectNoiseParameters parameters_;
  std::uint64_t seed_;
};

}  // namespace line_plane_segmentation::simulation
