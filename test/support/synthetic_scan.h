// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/parameters.h"
#include "lines/scanline.h"
#include "support/random.h"

/// 2-D scans of a few straight pieces, made for tests.
namespace line_plane_segmentation {

/// The rays of a scanline through the optical centre: pixel i looks along (1, (i - centre) / focal_length).
struct ScanCamera {
  double focal_length = 525.0;  ///< [px]
  double centre = 319.5;        ///< [px]

  double ray(double pixel) const { return (pixel - centre) / focal_length; }
};

/// The pixels first to last, both included, of the line Sx cos(alpha) + Sy sin(alpha) = r.
struct ScanPiece {
  int first, last;
  double alpha, r;
};

/// The piece on the line of that direction that meets the ray of `pixel` at depth z [m].
ScanPiece pieceThrough(const ScanCamera& camera, double pixel, double z, double alpha, int first, int last);

/// A scan of the pieces, pixels of no piece being holes.
Scanline scanOf(const ScanCamera& camera, const std::vector<ScanPiece>& pieces);

/// Moves every point along its ray by the noise of Eq. 5 times `factor`.
void addNoise(const NoiseParameters& noise, double factor, Random& random, Scanline& scan);

/// Moves every point along its ray to the next step of a Kinect's disparity, 2.85e-3 z² [m] wide.
void quantize(Scanline& scan);

}  // namespace line_plane_segmentation
