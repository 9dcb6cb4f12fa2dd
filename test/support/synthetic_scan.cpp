// SPDX-License-Identifier: BSD-3-Clause
#include "support/synthetic_scan.h"

#include <cmath>

namespace line_plane_segmentation {
namespace {

void moveTo(double z, ScanPoint& point) {
  point.x *= z / point.z;
  point.y *= z / point.z;
  point.z = z;
}

}  // namespace

ScanPiece pieceThrough(const ScanCamera& camera, double pixel, double z, double alpha, int first, int last) {
  return {first, last, alpha, z * (std::cos(alpha) + camera.ray(pixel) * std::sin(alpha))};
}

Scanline scanOf(const ScanCamera& camera, const std::vector<ScanPiece>& pieces) {
  Scanline scan;
  for (const ScanPiece& piece : pieces) {
    for (int pixel = piece.first; pixel <= piece.last; ++pixel) {
      const double ray = camera.ray(pixel);
      const double z = piece.r / (std::cos(piece.alpha) + ray * std::sin(piece.alpha));
      scan.points.push_back({pixel, z, ray * z, z});
    }
  }
  return scan;
}

void addNoise(const NoiseParameters& noise, double factor, Random& random, Scanline& scan) {
  for (ScanPoint& point : scan.points) {
    moveTo(point.z + factor * noise.sigma(point.z) * random.gaussian(), point);
  }
}

void quantize(Scanline& scan) {
  constexpr double kStep = 2.85e-3;  // [1/m] of the inverse depth
  for (ScanPoint& point : scan.points) moveTo(1.0 / (kStep * std::round(1.0 / (kStep * point.z))), point);
}

}  // namespace line_plane_segmentation
