// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// Fraction of the image at which the residual distortion of the sensor is as large as what the bounds for
/// small planes allow.
constexpr double kDistortedFraction = 0.045;

/// A bound of a mean square deviation, for a plane that covers a fraction of the image [0, 1]. Residual sensor
/// distortion bends a plane smoothly: its deviation grows with the square of its extent, and the mean square
/// with the square of that fraction.
constexpr double allowDistortion(double bound, double fraction) {
  const double relative = fraction / kDistortedFraction;
  return bound * (1.0 + relative * relative);
}

}  // namespace line_plane_segmentation
