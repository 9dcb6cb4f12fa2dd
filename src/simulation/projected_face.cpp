// SPDX-License-Identifier: BSD-3-Clause
#include "projected_face.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace line_plane_segmentation::simulation {

ProjectedFace::ProjectedFace(const std::vector<Eigen::Vector3d>& vertices, const VisiblePlane& plane,
                             const CameraIntrinsics& k, int height)
    : label_(plane.label),
      inverse_depth_(productWithRays(-plane.normal / plane.d, k)),
      last_row_(height - 1) {
  // A ray is on the inner side of a polygon's side if it is so of the plane through that side and the
  // camera. Two faces get the same numbers for a common side, but for the sign, so there is no gap.
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    sides_.push_back(productWithRays(vertices[(i + 1) % vertices.size()].cross(vertices[i]), k));
  }
  limitRows(vertices, k);
}

void ProjectedFace::draw(int v, ImageRow& row) const {
  if (v < first_row_ || v > last_row_) return;
  const double slope = inverse_depth_.per_column;
  const double offset = inverse_depth_.inRow(v);
  ColumnSpan span = row.allColumns();
  for (const LinearInPixels& side : sides_) span.cut(side.per_column, side.inRow(v));
  if (span.empty()) return;

  double* inverse_depth = row.inverse_depth.data();
  std::int64_t* labels = row.labels.data();
  const int end = span.end();
  for (int u = span.begin(); u < end; ++u) {
    const double here =
        slope * u + offset;  // negative where the plane's other part, behind the camera, is met
    const bool nearer = here > inverse_depth[u];
    inverse_depth[u] = nearer ? here : inverse_depth[u];
    labels[u] = nearer ? label_ : labels[u];
  }
}

/// Spares the rows that the face cannot reach. Where part of it lies beside or behind the camera, its rows
/// are not those between its vertices: it keeps them all.
void ProjectedFace::limitRows(const std::vector<Eigen::Vector3d>& vertices, const CameraIntrinsics& k) {
  double top = std::numeric_limits<double>::infinity();
  double bottom = -top;
  for (const Eigen::Vector3d& vertex : vertices) {
    if (!(vertex.z() > 1e-3)) return;
    const double v = k.fy * vertex.y() / vertex.z() + k.cy;
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
  const double height = last_row_ + 1;
  first_row_ = static_cast<int>(std::clamp(std::floor(top), 0.0, height));
  last_row_ = static_cast<int>(std::clamp(std::ceil(bottom), -1.0, height - 1.0));
}

}  // namespace line_plane_segmentation::simulation
