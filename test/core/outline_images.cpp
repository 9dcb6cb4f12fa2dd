// SPDX-License-Identifier: BSD-3-Clause
#include "core/outline_images.h"

#include <cmath>

#include "core/outline_checks.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

/// Gives every pixel what `label_at(u, v)` says.
template <typename LabelAt>
std::vector<std::uint16_t> drawn(int width, int height, LabelAt&& label_at) {
  std::vector<std::uint16_t> labels;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) labels.push_back(static_cast<std::uint16_t>(label_at(u, v)));
  }
  return labels;
}

std::vector<std::uint16_t> noise(int width, int height, Random& random) {
  const double density = random.uniform(0.1, 0.9);
  const int labels = random.integer(1, 3);
  return drawn(width, height,
               [&](int, int) { return random.chance(density) ? random.integer(1, labels) : 0; });
}

std::vector<std::uint16_t> blobs(int width, int height, Random& random) {
  std::vector<std::uint16_t> labels(static_cast<std::size_t>(width * height), 0);
  const double raggedness = random.uniform(0.0, 2.0);
  for (int blob = 0; blob < 14; ++blob) {
    const double u0 = random.uniform(0.0, width), v0 = random.uniform(0.0, height);
    const double radius = random.uniform(1.0, 0.35 * width);
    const int label = random.integer(0, 2);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const double distance = std::hypot(u - u0, v - v0) + raggedness * random.uniform(-1.0, 1.0);
        if (distance < radius)
          labels[static_cast<std::size_t>(v * width + u)] = static_cast<std::uint16_t>(label);
      }
    }
  }
  return labels;
}

std::vector<std::uint16_t> spiral(int width, int height, Random& random) {
  const double pitch = random.uniform(2.0, 6.0), fraction = random.uniform(0.3, 0.7);
  const double squareness = random.uniform(0.0, 1.0), u0 = 0.5 * width, v0 = 0.5 * height;
  return drawn(width, height, [&](int u, int v) {
    const double x = u - u0, y = v - v0;
    const double radius =
        (1.0 - squareness) * std::hypot(x, y) + squareness * std::max(std::abs(x), std::abs(y));
    const double turns = radius / pitch - std::atan2(y, x) / 6.283185307179586;
    return turns - std::floor(turns) < fraction ? 1 : 0;
  });
}

std::vector<std::uint16_t> checkerboard(int width, int height, Random& random) {
  const int cell = random.integer(1, 4), other = random.integer(0, 2);
  const double flips = random.chance(0.5) ? 0.0 : 0.05;
  return drawn(width, height, [&](int u, int v) {
    return ((u / cell + v / cell) % 2 == 0) != random.chance(flips) ? 1 : other;
  });
}

std::vector<std::uint16_t> lines(int width, int height, Random& random) {
  const int paper = random.integer(0, 1);
  std::vector<std::uint16_t> labels(static_cast<std::size_t>(width * height),
                                    static_cast<std::uint16_t>(paper));
  for (int line = random.integer(1, 8); line > 0; --line) {
    const double u0 = random.uniform(0.0, width), v0 = random.uniform(0.0, height);
    const double u1 = random.uniform(0.0, width), v1 = random.uniform(0.0, height);
    // Fine steps join the pixels of a line by their sides, coarse ones let some touch at corners only.
    const int steps =
        random.chance(0.5) ? 4 * width : static_cast<int>(std::max(std::abs(u1 - u0), std::abs(v1 - v0)));
    for (int i = 0; i <= steps; ++i) {
      const int u = static_cast<int>(u0 + (u1 - u0) * i / std::max(steps, 1));
      const int v = static_cast<int>(v0 + (v1 - v0) * i / std::max(steps, 1));
      labels[static_cast<std::size_t>(v * width + u)] = static_cast<std::uint16_t>(1 - paper);
    }
  }
  return labels;
}

std::vector<std::uint16_t> nestedRings(int width, int height, Random& random) {
  const double squeeze = random.uniform(0.5, 1.5), pitch = random.uniform(1.0, 5.0),
               wobble = random.uniform(0.0, 2.0);
  return drawn(width, height, [&](int u, int v) {
    const double x = u - 0.47 * width, y = squeeze * (v - 0.52 * height);
    return static_cast<int>((std::hypot(x, y) + wobble * std::sin(5.0 * std::atan2(y, x))) / pitch + 5.0) % 2;
  });
}

std::vector<std::uint16_t> stripes(int width, int height, Random& random) {
  const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0),
               offset = random.uniform(0.0, 2.0);
  const double fraction = random.uniform(0.3, 0.9), bend = random.uniform(-0.01, 0.01);
  return drawn(width, height, [&](int u, int v) {
    const double stripe = x * u + y * v + bend * u * u + offset;
    return stripe - std::floor(stripe) < fraction ? 1 : 0;
  });
}

std::vector<std::uint16_t> mosaic(int width, int height, Random& random) {
  const int cells = random.integer(2, 9);
  const double raggedness = random.uniform(0.0, 4.0);
  std::vector<Eigen::Vector2d> centers;
  for (int k = 0; k < cells; ++k)
    centers.emplace_back(random.uniform(0.0, width), random.uniform(0.0, height));
  return drawn(width, height, [&](int u, int v) {
    const Eigen::Vector2d at(u + raggedness * random.uniform(-1.0, 1.0),
                             v + raggedness * random.uniform(-1.0, 1.0));
    int nearest = 0;
    for (int k = 1; k < cells; ++k) {
      const Eigen::Vector2d& best = centers[static_cast<std::size_t>(nearest)];
      if ((centers[static_cast<std::size_t>(k)] - at).norm() < (best - at).norm()) nearest = k;
    }
    return nearest;
  });
}

std::vector<std::uint16_t> comb(int width, int height, Random& random) {
  const int tooth = random.integer(1, 3), gap = random.integer(1, 3), back = random.integer(1, height - 1);
  const double slant = random.uniform(0.0, 0.6);
  return drawn(width, height, [&](int u, int v) {
    return v < back || (u + static_cast<int>(slant * v)) % (tooth + gap) < tooth ? 1 : 0;
  });
}

std::vector<std::uint16_t> full(int width, int height, Random& random) {
  std::vector<std::uint16_t> labels(static_cast<std::size_t>(width * height), 1);
  for (int hole = random.integer(0, 12); hole > 0; --hole) {
    const int u0 = random.integer(0, width - 1), v0 = random.integer(0, height - 1);
    const int u1 = std::min(u0 + random.integer(1, 9), width),
              v1 = std::min(v0 + random.integer(1, 9), height);
    for (int v = v0; v < v1; ++v) {
      for (int u = u0; u < u1; ++u) labels[static_cast<std::size_t>(v * width + u)] = 0;
    }
  }
  return labels;
}

std::vector<std::uint16_t> labelsOf(OutlinePicture picture, int width, int height, Random& random) {
  switch (picture) {
    case OutlinePicture::kNoise:
      return noise(width, height, random);
    case OutlinePicture::kBlobs:
      return blobs(width, height, random);
    case OutlinePicture::kSpiral:
      return spiral(width, height, random);
    case OutlinePicture::kCheckerboard:
      return checkerboard(width, height, random);
    case OutlinePicture::kLines:
      return lines(width, height, random);
    case OutlinePicture::kNestedRings:
      return nestedRings(width, height, random);
    case OutlinePicture::kStripes:
      return stripes(width, height, random);
    case OutlinePicture::kMosaic:
      return mosaic(width, height, random);
    case OutlinePicture::kComb:
      return comb(width, height, random);
    case OutlinePicture::kFull:
      return full(width, height, random);
  }
  return {};
}

}  // namespace

std::string nameOf(OutlinePicture picture) {
  constexpr const char* kNames[] = {"Noise",       "Blobs",   "Spiral", "Checkerboard", "Lines",
                                    "NestedRings", "Stripes", "Mosaic", "Comb",         "Full"};
  return kNames[static_cast<int>(picture)];
}

Segmentation outlinePicture(OutlinePicture picture, int width, int height, std::uint64_t seed) {
  Random random(seed * 16 + static_cast<std::uint64_t>(picture));
  Segmentation segmentation = segmentationOf(width, height, labelsOf(picture, width, height, random));
  for (SegmentedPlane& plane : segmentation.planes) {
    // Little enough that every ray of outlineCamera() meets the plane.
    const Eigen::Vector3d normal(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), -1.0);
    tilt(normal, random.uniform(0.5, 5.0), plane);
  }
  return segmentation;
}

}  // namespace line_plane_segmentation
