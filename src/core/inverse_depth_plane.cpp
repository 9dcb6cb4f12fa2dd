// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/inverse_depth_plane.h"

namespace line_plane_segmentation {

RegressionMoments& RegressionMoments::operator+=(const RegressionMoments& other) {
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  x += other.x;
  y += other.y;
  one += other.one;
  xw += other.xw;
  yw += other.yw;
  w += other.w;
  ww += other.ww;
  pixels += other.pixels;
  return *this;
}

void RegressionMoments::scale(double weight) {
  for (double* sum : {&xx, &xy, &yy, &x, &y, &one, &xw, &yw, &w, &ww}) *sum *= weight;
}

double RegressionMoments::squaredErrorTo(const InverseDepthPlane& p) const {
  const double squares = p.a * p.a * xx + p.b * p.b * yy + p.c * p.c * one;
  const double products = p.a * p.b * xy + p.a * p.c * x + p.b * p.c * y;
  return std::max(0.0, ww - 2.0 * (p.a * xw + p.b * yw + p.c * w) + squares + 2.0 * products);
}

double RegressionMoments::fit(InverseDepthPlane& plane) const {
  if (!(one > 0.0)) return -1.0;
  const double share = 1.0 / one;
  const double x_mean = x * share, y_mean = y * share, w_mean = w * share;
  const double cxx = xx - x * x_mean, cxy = xy - x * y_mean, cyy = yy - y * y_mean;
  const double cxw = xw - x * w_mean, cyw = yw - y * w_mean, cww = ww - w * w_mean;
  const double determinant = cxx * cyy - cxy * cxy;
  if (!(determinant > 1e-9 * cxx * cyy)) return -1.0;
  const double inverse = 1.0 / determinant;
  plane.a = (cyy * cxw - cxy * cyw) * inverse;
  plane.b = (cxx * cyw - cxy * cxw) * inverse;
  plane.c = w_mean - plane.a * x_mean - plane.b * y_mean;
  return std::max(0.0, cww - plane.a * cxw - plane.b * cyw);
}

}  // namespace line_plane_segmentation
