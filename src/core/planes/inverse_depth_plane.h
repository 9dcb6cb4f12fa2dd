// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// A plane as the camera sees it. Along the rays (x, y, 1) the inverse depth rho = 1/z of a plane
/// n . p + d = 0 is affine, rho = a x + b y + c with (a, b, c) = -n / d: a straight line along every
/// scanline. The inverse depth of a disparity sensor has nearly the same noise near and far.
struct InverseDepthPlane {
  double a = 0.0, b = 0.0, c = 0.0;  ///< [1/m]

  double at(double x, double y) const { return a * x + b * y + c; }

  /// 1 / d [1/m], d being the plane's distance to the camera.
  double inverseDistance() const { return std::sqrt(a * a + b * b + c * c); }
};

/// Maximum deviation of a pixel from its plane: a multiple of the depth noise (Eq. 5) along the ray, or an
/// orthogonal distance to the plane, whichever is greater.
struct DepthTolerance {
  NoiseParameters noise;
  double noise_factor = 0.0;  ///< [-] multiple of sigma_z
  double distance = 0.0;      ///< [m] orthogonal distance

  /// The noise term in inverse depth [1/m]: noise_factor * sigma_z / z², with rho = 1/z.
  double along(double rho) const {
    const double reach = 1.0 - noise.nearest * rho;
    return noise_factor * (noise.floor * rho * rho + noise.growth * reach * reach);
  }

  /// The tolerance [1/m] at inverse depth rho. A point at the orthogonal distance h from the plane
  /// n . p + d = 0 differs from it by h rho / d in inverse depth.
  double at(double rho, double inverse_distance) const {
    return std::max(along(rho), distance * rho * inverse_distance);
  }

  /// The square of at(), from the square of the inverse distance.
  double squaredAt(double rho, double inverse_distance2) const {
    const double noise_term = along(rho), distance_term = distance * rho;
    return std::max(noise_term * noise_term, distance_term * distance_term * inverse_distance2);
  }
};

/// Weighted sums over pixels, from which a plane is fitted in constant time by linear regression of the
/// inverse depth rho on the ray (x, y). The weight of a pixel is 1 / tolerance², so that squared errors are
/// in units of tolerance².
struct RegressionMoments {
  double xx = 0.0, xy = 0.0, yy = 0.0, x = 0.0, y = 0.0, weight = 0.0;
  double x_rho = 0.0, y_rho = 0.0, rho = 0.0, rho_rho = 0.0;
  double pixels = 0.0;  ///< number of pixels, unweighted

  // Operators and fit() are in the header to be inlined: they run thousands of times a frame.
  RegressionMoments operator+(const RegressionMoments& o) const {
    return {xx + o.xx,   xy + o.xy,           yy + o.yy,        x + o.x,
            y + o.y,     weight + o.weight,   x_rho + o.x_rho,  y_rho + o.y_rho,
            rho + o.rho, rho_rho + o.rho_rho, pixels + o.pixels};
  }
  RegressionMoments& operator+=(const RegressionMoments& other) { return *this = *this + other; }

  /// Multiplies the weight of every pixel by `factor`.
  void scale(double factor) {
    *this = {xx * factor,    xy * factor,    yy * factor,  x * factor,       y * factor, weight * factor,
             x_rho * factor, y_rho * factor, rho * factor, rho_rho * factor, pixels};
  }

  /// Fits the plane, without a branch, so that loops over it can be vectorised.
  /// @param squared_error  receives the weighted sum of squared errors of the pixels
  /// @return false if the pixels are degenerate (on one line of the image, or none); plane and error are
  ///         then undefined
  bool fit(InverseDepthPlane& plane, double& squared_error) const;
};

inline bool RegressionMoments::fit(InverseDepthPlane& plane, double& squared_error) const {
  // Centred moments, times `weight`, so that no division waits for another one.
  const double cxx = weight * xx - x * x, cxy = weight * xy - x * y, cyy = weight * yy - y * y;
  const double cxr = weight * x_rho - x * rho, cyr = weight * y_rho - y * rho;
  const double crr = weight * rho_rho - rho * rho;
  const double determinant = cxx * cyy - cxy * cxy;
  const double inv_determinant = 1.0 / determinant, inv_weight = 1.0 / weight;
  plane.a = (cyy * cxr - cxy * cyr) * inv_determinant;
  plane.b = (cxx * cyr - cxy * cxr) * inv_determinant;
  plane.c = (rho - plane.a * x - plane.b * y) * inv_weight;
  squared_error = std::max(0.0, (crr - plane.a * cxr - plane.b * cyr) * inv_weight);
  // Also false for zero pixels: the determinant is 0 then.
  return determinant > 1e-9 * cxx * cyy;
}

/// Neighbouring pixels share their errors: so many count as one in the covariance of a fitted plane. Measured
/// on simulated frames, whose planes are known.
constexpr double kSharedErrors = 12.0;

/// Pixels and the plane that fits them best.
struct FittedPixels {
  RegressionMoments moments;
  InverseDepthPlane plane;
  double squared_error = 0.0;  ///< [tolerance²] sum over the pixels
};

}  // namespace line_plane_segmentation
