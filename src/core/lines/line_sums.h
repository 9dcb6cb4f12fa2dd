// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// Sums over the pixels of a piece of a scanline that have a depth, from which a line is fitted in constant
/// time: of their number, of the ray coordinate t along the scanline, and of the inverse depth rho = 1/z.
/// The scan of a plane is the line rho = slope t + offset. A `Number` is a double, or a vector of them with
/// one piece in each lane.
template <typename Number>
struct LineSumsOf {
  Number n{}, t{}, tt{}, rho{}, t_rho{}, rho_rho{};

  LineSumsOf operator+(const LineSumsOf& o) const {
    return {n + o.n, t + o.t, tt + o.tt, rho + o.rho, t_rho + o.t_rho, rho_rho + o.rho_rho};
  }
};
using LineSums = LineSumsOf<double>;

/// The line rho = slope t + offset through pixels, by linear regression.
template <typename Number>
struct InverseDepthLineOf {
  Number slope{}, offset{};
  Number squared_error{};  ///< [1/m²] sum over the pixels
  Number inv_n{};          ///< 1 / number of pixels
};
using InverseDepthLine = InverseDepthLineOf<double>;

/// Fits the line through at least one pixel, without a branch. A single pixel has the slope 0.
template <typename Number>
inline InverseDepthLineOf<Number> fitThroughPixels(const LineSumsOf<Number>& sums) {
  const Number zero{}, one = zero + 1.0;
  // Centred moments, times n. One division for both quotients, since it takes as long as the rest.
  const Number ctt = sums.n * sums.tt - sums.t * sums.t, ctr = sums.n * sums.t_rho - sums.t * sums.rho;
  const Number crr = sums.n * sums.rho_rho - sums.rho * sums.rho;
  const auto is_line = ctt > zero;
  const Number divisor = is_line ? sums.n * ctt : sums.n;
  const Number inv = one / divisor;
  const Number inv_n = is_line ? inv * ctt : inv;
  const Number slope = is_line ? inv * sums.n * ctr : zero;
  const Number squared_error = (crr - slope * ctr) * inv_n;
  return {slope, (sums.rho - slope * sums.t) * inv_n, squared_error > zero ? squared_error : zero, inv_n};
}

/// Fits the line. A single pixel has the slope 0; without pixels all is 0.
inline InverseDepthLine fitInverseDepthLine(const LineSums& sums) {
  if (!(sums.n > 0.0)) return {};
  return fitThroughPixels(sums);
}

}  // namespace line_plane_segmentation
