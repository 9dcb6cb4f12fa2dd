// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kinect_noise.h"
#include "line_plane_segmentation/camera_intrinsics.h"
#include "renderer.h"
#include "room.h"

namespace line_plane_segmentation::simulation {

constexpr int kMaxImageSide = 4096;  ///< [px]

/// Returns the intrinsics of a Kinect or Xtion with images of this size: focal length 525 px at 640 columns,
/// optical axis in the centre.
/// @param width,height  [px], positive
CameraIntrinsics kinectIntrinsics(int width, int height);

/// Simulated Kinect that moves through a simulated room. Reads no clock: a frame depends only on the seed,
/// its number and its time.
class SimulatedCamera {
 public:
  /// Settings of the camera.
  struct Options {
    std::uint64_t seed = 1;  ///< of the room, the path and the noise
    int width = 640;         ///< [px] 1 to kMaxImageSide
    int height = 480;        ///< [px] 1 to kMaxImageSide
    bool noise = true;       ///< false = exact depth, rounded to millimetres
  };

  /// @throw std::invalid_argument  if the size is out of its range
  explicit SimulatedCamera(const Options& options);

  /// Captures an image.
  /// @param frame  number of the frame, which determines its noise
  /// @param seconds   [s] time on the path
  /// @param depth_mm  [mm] output, width * height pixels, 0 = invalid (REP 118)
  /// @return ground truth of that image, valid until the next call
  const Rendering& capture(std::uint64_t frame, double seconds, std::uint16_t* depth_mm);

  /// Returns the pose of the optical frame in the world (z up) at this time.
  Eigen::Isometry3d pose(double seconds) const { return room_.path.pose(seconds); }

  /// Returns the intrinsics of the images.
  const CameraIntrinsics& intrinsics() const { return intrinsics_; }
  /// Returns the options given to the constructor.
  const Options& options() const { return options_; }
  /// Returns the room that the camera moves through.
  const Room& room() const { return room_; }

 private:
  Options options_;
  CameraIntrinsics intrinsics_;
  Room room_;
  KinectNoise noise_;
  Rendering rendering_;
};

}  // namespace line_plane_segmentation::simulation
