// SPDX-License-Identifier: BSD-3-Clause
#include "support/synthetic_depth.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr double kFarthest = 20.0;  // [m] a surface seen at a glance does not go on forever

Region randomRegion(int width, int height, Random& random) {
  Region region{};
  region.first_u = random.integer(0, width - 1);
  region.last_u = random.integer(region.first_u + 1, width);
  region.first_v = random.integer(0, height - 1);
  region.last_v = random.integer(region.first_v + 1, height);
  return region;
}

DepthImage equalSquares(int width, int height, Random& random) {
  const CameraIntrinsics camera = kinectCamera(width, height);
  DepthImage depth = blankDepth(width, height);
  const int side = random.integer(4, 12);
  for (int v = 0; v + side <= height; v += side) {
    for (int u = 0; u + side <= width; u += side) {
      paint(surfaceAt(random.integer(4, 8) * 0.25), camera, {u, u + side, v, v + side}, depth);
    }
  }
  return depth;
}

}  // namespace

Surface surfaceAt(double distance, double yaw, double pitch) {
  const Eigen::Vector3d normal(std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                               -std::cos(yaw) * std::cos(pitch));
  return {normal, -normal.z() * distance};
}

CameraIntrinsics kinectCamera(int width, int height) {
  const double focal_length = 525.0 * width / 640.0;
  return {focal_length, focal_length, 0.5 * (width - 1), 0.5 * (height - 1)};
}

ViewRays raysOf(const CameraIntrinsics& camera, int width, int height) {
  ViewRays rays;
  rays.compute(camera, width, height);
  return rays;
}

DepthImage blankDepth(int width, int height) {
  DepthImage depth;
  depth.width = width;
  depth.height = height;
  depth.z.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F);
  return depth;
}

void paint(const Surface& surface, const CameraIntrinsics& camera, const Region& region, DepthImage& depth) {
  for (int v = region.first_v; v < region.last_v; ++v) {
    for (int u = region.first_u; u < region.last_u; ++u) {
      const double z = surface.depthAlong((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
      if (z > 0.0 && z < kFarthest) depth.row(v)[u] = static_cast<float>(z);
    }
  }
}

DepthImage render(const Surface& surface, const CameraIntrinsics& camera, int width, int height) {
  DepthImage depth = blankDepth(width, height);
  paint(surface, camera, {0, width, 0, height}, depth);
  return depth;
}

DepthImage halves(const Surface& left, const Surface& right, const CameraIntrinsics& camera, int width,
                  int height) {
  DepthImage depth = blankDepth(width, height);
  paint(left, camera, {0, width / 2, 0, height}, depth);
  paint(right, camera, {width / 2, width, 0, height}, depth);
  return depth;
}

void addNoise(const NoiseParameters& noise, double factor, Random& random, DepthImage& depth) {
  for (float& z : depth.z) {
    if (z > 0.0F) z = static_cast<float>(std::max(1e-3, z + factor * noise.sigma(z) * random.gaussian()));
  }
}

void addHoles(double fraction, int patches, Random& random, DepthImage& depth) {
  for (float& z : depth.z) {
    if (random.chance(fraction)) z = 0.0F;
  }
  for (int i = 0; i < patches; ++i) {
    Region hole = randomRegion(depth.width, depth.height, random);
    hole.last_u = std::min(hole.last_u, hole.first_u + depth.width / 4);
    hole.last_v = std::min(hole.last_v, hole.first_v + depth.height / 4);
    for (int v = hole.first_v; v < hole.last_v; ++v) {
      std::fill(depth.row(v) + hole.first_u, depth.row(v) + hole.last_u, 0.0F);
    }
  }
}

DepthImage randomScene(std::uint64_t seed, int width, int height) {
  Random random(seed);
  if (random.chance(0.25)) return equalSquares(width, height, random);

  const CameraIntrinsics camera = kinectCamera(width, height);
  const double distance = random.uniform(0.6, 4.0);
  DepthImage depth = render(surfaceAt(distance, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)), camera,
                            width, height);
  for (int i = random.integer(0, 6); i > 0; --i) {
    const double step = random.uniform(0.0, 0.3);
    const Surface patch = surfaceAt(distance - step, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    paint(patch, camera, randomRegion(width, height, random), depth);
  }
  addNoise({}, random.chance(0.3) ? 0.0 : random.uniform(0.1, 1.5), random, depth);
  addHoles(random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.2), random.integer(0, 3), random, depth);
  return depth;
}

std::vector<std::uint16_t> toMillimetres(const DepthImage& depth) {
  std::vector<std::uint16_t> pixels(depth.z.size());
  std::transform(depth.z.begin(), depth.z.end(), pixels.begin(), [](float z) {
    return static_cast<std::uint16_t>(std::clamp(std::lround(1000.0 * static_cast<double>(z)), 0L, 65535L));
  });
  return pixels;
}

Eigen::Vector3d pointAt(const DepthImage& depth, const ViewRays& rays, int u, int v) {
  const double z = depth.at(u, v);
  return {z * rays.x[static_cast<std::size_t>(u)], z * rays.y[static_cast<std::size_t>(v)], z};
}

}  // namespace line_plane_segmentation
