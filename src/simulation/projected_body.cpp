// SPDX-License-Identifier: BSD-3-Clause
#include "projected_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace line_plane_segmentation::simulation {
namespace {

/// c2 u^2 + c1 u + c0
struct Quadratic {
  double c2 = 0.0;
  double c1 = 0.0;
  double c0 = 0.0;

  double at(int u) const { return (c2 * u + c1) * u + c0; }
};

/// Cuts from `span` columns where `f` is negative; some may stay.
void cutNegative(const Quadratic& f, ColumnSpan& span) {
  if (f.c2 >= 0.0) return;
  const double center = -0.5 * f.c1 / f.c2;
  const double square = center * center - f.c0 / f.c2;
  if (square < 0.0) {
    span = {};
    return;
  }
  const double half_width = std::sqrt(square);
  span.cut(1.0, half_width - center);
  span.cut(-1.0, half_width + center);
}

}  // namespace

ProjectedBody::ProjectedBody(const CurvedBody& body, const Eigen::Isometry3d& camera,
                             const CameraIntrinsics& k)
    : vault_(body.vault), springing_(body.center.z() - camera.translation().z()) {
  const Eigen::Vector3d origin = body.shape * (camera.translation() - body.center);
  const Eigen::Matrix3d to_body = body.shape * camera.linear();
  c_ = origin.squaredNorm() - 1.0;
  b_ = productWithRays(to_body.transpose() * origin, k);
  for (int axis = 0; axis < 3; ++axis) q_[axis] = productWithRays(to_body.row(axis).transpose(), k);
  climb_ = productWithRays(camera.linear().row(2).transpose(), k);
}

void ProjectedBody::draw(int v, ImageRow& row) const {
  // |q|^2 z^2 + 2 b z + c = 0, so 1 / z = (-b +- sqrt(b^2 - |q|^2 c)) / c: only the root changes with
  // more than the first power of u.
  const double b1 = b_.per_column;
  const double b0 = b_.inRow(v);
  Quadratic discriminant{b1 * b1, 2.0 * b1 * b0, b0 * b0};
  for (const LinearInPixels& q : q_) {
    discriminant.c2 -= c_ * q.per_column * q.per_column;
    discriminant.c1 -= c_ * 2.0 * q.per_column * q.inRow(v);
    discriminant.c0 -= c_ * q.inRow(v) * q.inRow(v);
  }
  ColumnSpan span = row.allColumns();
  cutNegative(discriminant, span);
  if (span.empty()) return;

  const double sign = vault_ ? -1.0 : 1.0;  // a body is seen on its near side, a vault on its far one
  const double inverse_c = 1.0 / c_;
  const double lowest = vault_ ? springing_ : -std::numeric_limits<double>::max();
  const double climb1 = climb_.per_column;
  const double climb0 = climb_.inRow(v);
  double* inverse_depth = row.inverse_depth.data();
  std::int64_t* labels = row.labels.data();
  const int end = span.end();
  for (int u = span.begin(); u < end; ++u) {
    const double square = discriminant.at(u);
    const double here = (sign * std::sqrt(std::max(square, 0.0)) - (b1 * u + b0)) * inverse_c;
    const bool hit = square >= 0.0 && climb1 * u + climb0 >= lowest * here;
    const bool nearer = hit && here > inverse_depth[u];
    inverse_depth[u] = nearer ? here : inverse_depth[u];
    labels[u] = nearer ? 0 : labels[u];
  }
}

}  // namespace line_plane_segmentation::simulation
