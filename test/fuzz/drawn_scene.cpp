// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_scene.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "ros/test_clouds.h"
#include "ros/test_messages.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMostPixels = 1024;

// Rays meet the nearest or the farthest of some planes: convex and concave bodies.
void addPlanes(ByteReader& bytes, DrawnScene& scene) {
  const bool nearest = bytes.chance(128);
  const int count = bytes.integer(1, 4);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d normal =
        Eigen::Vector3d(bytes.uniform(-1.0, 1.0), bytes.uniform(-1.0, 1.0), -1.0).normalized();
    const double d = bytes.uniform(0.3, 6.0);
    for (std::uint32_t v = 0; v < scene.height; ++v) {
      for (std::uint32_t u = 0; u < scene.width; ++u) {
        const Eigen::Vector3d ray = rayOf(scene.camera, u, v);
        float& depth = scene.depth[std::size_t{v} * scene.width + u];
        const double z = -d / std::min(normal.dot(ray), -1e-3);
        if (i == 0 || (z < depth) == nearest) depth = static_cast<float>(z);
      }
    }
  }
}

void addTiles(ByteReader& bytes, DrawnScene& scene) {
  const auto across = static_cast<std::uint32_t>(bytes.integer(1, 6));
  const auto down = static_cast<std::uint32_t>(bytes.integer(1, 4));
  const auto side = static_cast<std::uint32_t>(bytes.integer(1, 24));
  std::vector<float> values(std::size_t{across} * down);
  for (float& value : values) {
    value = bytes.chance(64) ? bytes.awkward<float>() : static_cast<float>(bytes.uniform(0.2, 11.0));
  }
  for (std::uint32_t v = 0; v < scene.height; ++v) {
    for (std::uint32_t u = 0; u < scene.width; ++u) {
      scene.depth[std::size_t{v} * scene.width + u] =
          values[std::size_t{v / side % down} * across + u / side % across];
    }
  }
}

void addNoiseAndHoles(ByteReader& bytes, DrawnScene& scene) {
  Random random(bytes.raw<std::uint8_t>());
  const double noise = bytes.chance(160) ? std::pow(10.0, bytes.uniform(-4.0, 0.5)) : 0.0;
  const double step = bytes.chance(64) ? bytes.uniform(1e-3, 0.2) : 0.0;
  const double holes = bytes.chance(96) ? bytes.uniform(0.0, 1.0) : 0.0;
  const float hole = bytes.awkward<float>();
  for (float& depth : scene.depth) {
    if (noise > 0.0) depth += static_cast<float>(noise * random.gaussian());
    if (step > 0.0) depth = static_cast<float>(step * std::round(depth / step));
    if (holes > 0.0 && random.chance(holes)) depth = hole;
  }
}

// As a camera stores it, which has no number for what is farther than 65 m.
double storable(float depth, bool as_float) {
  return as_float || (depth > 0.0F && depth < 65.5F) ? depth : 0.0F;
}

}  // namespace

DrawnScene drawScene(ByteReader& bytes) {
  DrawnScene scene;
  const int width = bytes.integer(1, 96);
  scene.width = static_cast<std::uint32_t>(width);
  scene.height = static_cast<std::uint32_t>(std::min(bytes.integer(1, 96), std::max(1, kMostPixels / width)));
  scene.camera = testCamera(scene.width, scene.height);
  if (bytes.chance(64)) {
    scene.camera.fx *= bytes.uniform(0.2, 5.0);
    scene.camera.fy *= bytes.uniform(0.2, 5.0);
    scene.camera.cx += bytes.uniform(-100.0, 100.0);
    scene.camera.cy += bytes.uniform(-100.0, 100.0);
  }
  scene.depth.assign(std::size_t{scene.width} * scene.height, 0.0F);
  if (bytes.chance(64)) {
    addTiles(bytes, scene);
  } else {
    addPlanes(bytes, scene);
  }
  addNoiseAndHoles(bytes, scene);
  return scene;
}

sensor_msgs::Image imageOf(const DrawnScene& scene, ByteReader& bytes) {
  constexpr const char* kEncodings[] = {"16UC1", "32FC1", "mono16"};
  sensor_msgs::Image image = testImage(scene.width, scene.height, kEncodings[bytes.integer(0, 2)]);
  const bool swapped = bytes.chance(32);
  image.step += static_cast<std::uint32_t>(bytes.integer(0, 7));
  image.data = std::vector<std::uint8_t>(std::size_t{image.step} * image.height);
  const std::size_t size = pixelSize(image.encoding);
  for (std::uint32_t v = 0; v < scene.height; ++v) {
    for (std::uint32_t u = 0; u < scene.width; ++u) {
      setDepth(image, u, v, storable(scene.depth[std::size_t{v} * scene.width + u], size == 4));
      std::uint8_t* pixel = image.data.data() + std::size_t{v} * image.step + u * size;
      if (swapped) std::reverse(pixel, pixel + size);
    }
  }
  image.is_bigendian = swapped ? 1 : 0;
  return image;
}

sensor_msgs::PointCloud2 cloudOf(const DrawnScene& scene, ByteReader& bytes) {
  sensor_msgs::PointCloud2 cloud = testCloud(scene.width, scene.height);
  cloud.is_bigendian = bytes.chance(64) ? 1 : 0;
  for (std::uint32_t v = 0; v < scene.height; ++v) {
    for (std::uint32_t u = 0; u < scene.width; ++u) {
      const Eigen::Vector3d ray = rayOf(scene.camera, u, v);
      const float z = scene.depth[std::size_t{v} * scene.width + u];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto value = static_cast<float>(ray[static_cast<Eigen::Index>(i)]) * z;
        setCoordinate(cloud, u, v, i, value);
      }
    }
  }
  return cloud;
}

}  // namespace line_plane_segmentation
