// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kinect_noise.h"
#include "simulated_camera.h"

namespace line_plane_segmentation::simulation {

using Image = std::vector<std::uint16_t>;

constexpr int kWidth = 640;
constexpr int kHeight = 480;

inline KinectNoiseParameters allOff() {
  KinectNoiseParameters p;
  p.axial.floor = 0.0;
  p.axial.growth = 0.0;
  p.disparity_step = 0.0;
  p.min_range = 0.001;
  p.max_range = 65.535;
  p.projector_shadow = false;
  p.edge_dropout = 0.0;
  p.grazing_start = 1.6;
  p.grazing_end = 1.7;
  return p;
}

inline Rendering pictureOf(const Scene& scene,
                           const Eigen::Isometry3d& camera = Eigen::Isometry3d::Identity()) {
  Rendering picture;
  render(scene, camera, kinectIntrinsics(kWidth, kHeight), kWidth, kHeight, picture);
  return picture;
}

inline Rendering wallAt(double z, int width = kWidth, int height = kHeight) {
  Scene scene;
  scene.addRectangle({-100, -100, z}, {0, 200, 0}, {200, 0, 0});
  Rendering picture;
  render(scene, Eigen::Isometry3d::Identity(), kinectIntrinsics(width, height), width, height, picture);
  return picture;
}

inline Image apply(const KinectNoiseParameters& parameters, const Rendering& picture, std::uint64_t seed = 1,
                   std::uint64_t frame = 0) {
  Image mm(picture.depth.size(), 7);
  KinectNoise(parameters, seed)
      .apply(picture, kinectIntrinsics(picture.width, picture.height), frame, mm.data());
  return mm;
}

inline double missingShare(const Image& mm) {
  return static_cast<double>(std::count(mm.begin(), mm.end(), 0)) / static_cast<double>(mm.size());
}

}  // namespace line_plane_segmentation::simulation
