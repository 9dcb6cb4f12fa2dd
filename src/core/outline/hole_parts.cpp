// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/segmentation.h"

#include <cstddef>

namespace line_plane_segmentation {
namespace {

/// A ring as a polygon in two of its three coordinates.
class RingView {
 public:
  RingView(const Segmentation& segmentation, int ring, int x_axis, int y_axis)
      : ring_(segmentation.rings[ring]), vertices_(segmentation.vertices), x_axis_(x_axis), y_axis_(y_axis) {}

  int size() const { return ring_.vertex_count; }
  float x(int i) const { return vertex(i)[x_axis_]; }
  float y(int i) const { return vertex(i)[y_axis_]; }

  /// Even-odd rule: a ray from the point to the right crosses the ring an odd number of times.
  bool encloses(float px, float py) const {
    bool inside = false;
    for (int i = 0, last = size() - 1; i < size(); last = i++) {
      if ((y(i) > py) == (y(last) > py)) continue;
      const float crossing = x(i) + (py - y(i)) / (y(last) - y(i)) * (x(last) - x(i));
      if (px < crossing) inside = !inside;
    }
    return inside;
  }

  int countEnclosed(const RingView& other) const {
    int enclosed = 0;
    for (int i = 0; i < other.size(); ++i) enclosed += encloses(other.x(i), other.y(i)) ? 1 : 0;
    return enclosed;
  }

 private:
  const Eigen::Vector3f& vertex(int i) const { return vertices_[ring_.first_vertex + i]; }

  const Ring& ring_;
  const std::vector<Eigen::Vector3f>& vertices_;
  int x_axis_, y_axis_;
};

}  // namespace

std::vector<int> partsOfHoles(const Segmentation& segmentation, const SegmentedPlane& plane) {
  std::vector<int> parts(static_cast<std::size_t>(plane.hole_count), 0);
  if (plane.outer_ring_count < 2) return parts;

  // Without the coordinate along which the plane is seen most from the front, areas stay largest.
  int dropped = 0;
  plane.normal.cwiseAbs().maxCoeff(&dropped);
  const int x_axis = (dropped + 1) % 3, y_axis = (dropped + 2) % 3;
  for (int h = 0; h < plane.hole_count; ++h) {
    const RingView hole(segmentation, plane.first_ring + plane.outer_ring_count + h, x_axis, y_axis);
    // From the smallest: a part may lie in the hole of a larger one.
    for (int part = plane.outer_ring_count - 1; part > 0; --part) {
      const RingView outer(segmentation, plane.first_ring + part, x_axis, y_axis);
      if (2 * outer.countEnclosed(hole) <= hole.size()) continue;
      parts[h] = part;
      break;
    }
  }
  return parts;
}

}  // namespace line_plane_segmentation
