// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The simulated camera: depth images with exact ground truth, for demonstrations, tests and benchmarks.
/// Depends on Eigen and the core's headers only (CMake target line_plane_segmentation_simulation).
///
/// A camera in a furnished room:
///
///     SimulatedCamera camera({seed, 640, 480, true});
///     std::vector<std::uint16_t> depth(640 * 480);
///     const Rendering& truth = camera.capture(frame, frame / 30.0, depth.data());
///     // depth: millimetres as from a Kinect; truth.labels, truth.planes, truth.depth: without any error
///
/// Your own scene, with or without noise:
///
///     Scene scene;
///     scene.addRectangle({-1, -1, 2}, {0, 2, 0}, {2, 0, 0});  // faces a camera at the origin
///     Rendering truth;
///     render(scene, Eigen::Isometry3d::Identity(), kinectIntrinsics(640, 480), 640, 480, truth);
///     KinectNoise({}, seed).apply(truth, kinectIntrinsics(640, 480), frame, depth.data());
///
/// All pixels of a plane have one label, even if a nearer object divides its image. Label 0 means no plane:
/// no surface, or a curved one. The ground truth is complete, also at pixels whose depth is invalid because
/// of noise.

#include "camera_path.h"
#include "kinect_noise.h"
#include "renderer.h"
#include "room.h"
#include "scene.h"
#include "simulated_camera.h"
