// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/inverse_depth_plane.h"

namespace line_plane_segmentation {

double RegressionMoments::squaredErrorTo(const InverseDepthPlane& p) const {
  const double squares = p.a * p.a * xx + p.b * p.b * yy + p.c * p.c * one;
  const double products = p.a * p.b * xy + p.a * p.c * x + p.b * p.c * y;
  return std::max(0.0, ww - 2.0 * (p.a * xw + p.b * yw + p.c * w) + squares + 2.0 * products);
}

}  // namespace line_plane_segmentation
