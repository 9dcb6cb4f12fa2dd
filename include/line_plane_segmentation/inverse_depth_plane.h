// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// A plane as the camera sees it. Along the rays (x, y, 1) the inverse depth w = 1/z of a plane n . p + d = 0
/// is affine, w = a x + b y + c with (a, b, c) = -n / d: a straight line along every scanline. The inverse
/// depth of a disparity sensor has, moreover, nearly the same noise near and far.
struct InverseDepthPlane {
  double a = 0.0, b = 0.0, c = 0.0;  ///< [1/m]

  double at(double x, double y) const { return a * x + b * y + c; }

  /// 1 / d [1/m], d being the plane's distance to the camera.
  double inverseDistance() const { return std::sqrt(a * a + b * b + c * c); }
};

/// How far a pixel may lie from its plane: along its ray by a multiple of the noise (Eq. 5), or across the
/// plane by a distance, whichever is more.
struct DepthTolerance {
  NoiseParameters noise;
  double noise_factor = 0.0;  ///< [-] multiple of sigma_z
  double distance = 0.0;      ///< [m] across the plane

  /// The noise's part of it, in inverse depth [1/m]: noise_factor * sigma_z / z², with w = 1/z.
  double along(double w) const {
    const double reach = 1.0 - noise.nearest * w;
    return noise_factor * (noise.floor * w * w + noise.growth * reach * reach);
  }

  /// The tolerance [1/m] at inverse depth w on a plane. A point at the distance h from the plane n . p + d =
  /// 0 differs from it by h w / d in inverse depth.
  double at(double w, double inverse_distance) const {
    return std::max(along(w), distance * w * inverse_distance);
  }
};

/// Weighted sums over pixels, from which a plane is fitted by linear regression of w on the ray, in constant
/// time. The weight of a pixel is its tolerance to the power of -2, so that squared errors are in units of
/// the tolerance.
struct RegressionMoments {
  double xx = 0.0, xy = 0.0, yy = 0.0, x = 0.0, y = 0.0, one = 0.0;
  double xw = 0.0, yw = 0.0, w = 0.0, ww = 0.0;
  double pixels = 0.0;  ///< unweighted

  // These and fit() are in the header since they are asked thousands of times a frame, many for sums that
  // nobody keeps.
  RegressionMoments operator+(const RegressionMoments& o) const {
    return {xx + o.xx, xy + o.xy, yy + o.yy, x + o.x,   y + o.y,          one + o.one,
            xw + o.xw, yw + o.yw, w + o.w,   ww + o.ww, pixels + o.pixels};
  }
  RegressionMoments& operator+=(const RegressionMoments& other) { return *this = *this + other; }

  /// Multiplies the weight of every pixel.
  void scale(double weight) {
    *this = {xx * weight, xy * weight, yy * weight, x * weight,  y * weight, one * weight,
             xw * weight, yw * weight, w * weight,  ww * weight, pixels};
  }

  /// The sum of squared errors of the pixels to a plane of any kind.
  double squaredErrorTo(const InverseDepthPlane& plane) const;

  /// Fits the plane, without a branch, so that many can be fitted at a time.
  /// @param squared_error  the sum of the pixels' squared errors
  /// @return whether the pixels fix a plane; if not, plane and error are of no use
  bool fit(InverseDepthPlane& plane, double& squared_error) const;

  /// Fits the plane.
  /// @return the sum of squared errors, or a negative number if the pixels do not fix a plane
  double fit(InverseDepthPlane& plane) const {
    double squared_error = 0.0;
    return fit(plane, squared_error) ? squared_error : -1.0;
  }
};

inline bool RegressionMoments::fit(InverseDepthPlane& plane, double& squared_error) const {
  // The centred moments, times `one`: so no division waits for another.
  const double cxx = one * xx - x * x, cxy = one * xy - x * y, cyy = one * yy - y * y;
  const double cxw = one * xw - x * w, cyw = one * yw - y * w, cww = one * ww - w * w;
  const double determinant = cxx * cyy - cxy * cxy;
  const double inverse = 1.0 / determinant, share = 1.0 / one;
  plane.a = (cyy * cxw - cxy * cyw) * inverse;
  plane.b = (cxx * cyw - cxy * cxw) * inverse;
  plane.c = (w - plane.a * x - plane.b * y) * share;
  squared_error = std::max(0.0, (cww - plane.a * cxw - plane.b * cyw) * share);
  // Not so of no pixels, either, of which nothing is a number.
  return determinant > 1e-9 * cxx * cyy;
}

}  // namespace line_plane_segmentation
