// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace line_plane_segmentation {

/// Sums over the pixels of a piece of a scanline that have a depth, from which a line is fitted in constant
/// time: of their number, of the ray coordinate t along the scanline, and of the inverse depth rho = 1/z.
/// The scan of a plane is the line rho = slope t + offset.
struct LineSums {
  double n = 0.0, t = 0.0, tt = 0.0, rho = 0.0, t_rho = 0.0, rho_rho = 0.0;

  LineSums operator+(const LineSums& o) const {
    return {n + o.n, t + o.t, tt + o.tt, rho + o.rho, t_rho + o.t_rho, rho_rho + o.rho_rho};
  }
};

/// The line rho = slope t + offset through pixels, by linear regression.
struct InverseDepthLine {
  double slope = 0.0, offset = 0.0;
  double squared_error = 0.0;  ///< [1/m²] sum over the pixels
  double inv_n = 0.0;          ///< 1 / number of pixels
};

/// Fits the line. A single pixel has the slope 0; without pixels all is 0.
inline InverseDepthLine fitInverseDepthLine(const LineSums& sums) {
  if (!(sums.n > 0.0)) return {};
  // Centred moments, times n. One division for both quotients, since it takes as long as the rest.
  const double ctt = sums.n * sums.tt - sums.t * sums.t, ctr = sums.n * sums.t_rho - sums.t * sums.rho;
  const double crr = sums.n * sums.rho_rho - sums.rho * sums.rho;
  const bool is_line = ctt > 0.0;
  const double inv = 1.0 / (is_line ? sums.n * ctt : sums.n), inv_n = is_line ? inv * ctt : inv;
  const double slope = is_line ? inv * sums.n * ctr : 0.0;
  return {slope, (sums.rho - slope * sums.t) * inv_n, std::max(0.0, (crr - slope * ctr) * inv_n), inv_n};
}

}  // namespace line_plane_segmentation
