// SPDX-License-Identifier: BSD-3-Clause
#include "core/outline_checks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>

namespace line_plane_segmentation {
namespace {

struct Edge {
  Eigen::Vector2d from, to;
  std::size_t ring, index, next;
};

/// Twice the area of the triangle: positive if c is to the left of a to b, 0 if on the line.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool isWithinBox(const Edge& edge, const Eigen::Vector2d& point) {
  return (point.array() >= edge.from.array().min(edge.to.array())).all() &&
         (point.array() <= edge.from.array().max(edge.to.array())).all();
}

bool lies(const Eigen::Vector2d& point, const Edge& edge) {
  return turn(edge.from, edge.to, point) == 0.0 && isWithinBox(edge, point);
}

/// Whether two edges have a point in common.
bool meet(const Edge& a, const Edge& b) {
  const double b_from = turn(a.from, a.to, b.from), b_to = turn(a.from, a.to, b.to);
  const double a_from = turn(b.from, b.to, a.from), a_to = turn(b.from, b.to, a.to);
  if (b_from * b_to < 0.0 && a_from * a_to < 0.0) return true;
  return lies(b.from, a) || lies(b.to, a) || lies(a.from, b) || lies(a.to, b);
}

/// Edges that follow each other have one point in common, and no more unless the second goes back on the
/// first.
bool foldsBack(const Edge& first, const Edge& second) {
  return turn(first.from, first.to, second.to) == 0.0 &&
         (first.to - first.from).dot(second.to - second.from) <= 0.0;
}

}  // namespace

Segmentation segmentationOf(int width, int height, std::vector<std::uint16_t> labels) {
  Segmentation segmentation;
  segmentation.width = width;
  segmentation.height = height;
  const std::uint16_t count =
      labels.empty() ? std::uint16_t{0} : *std::max_element(labels.begin(), labels.end());
  segmentation.planes.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    segmentation.planes[k].label = static_cast<std::uint16_t>(k + 1);
    tilt({0.0, 0.0, -1.0}, 1.0 + 0.25 * static_cast<double>(k), segmentation.planes[k]);
  }
  segmentation.labels = std::move(labels);
  return segmentation;
}

Segmentation segmentationOf(const std::vector<std::string>& rows) {
  std::vector<std::uint16_t> labels;
  for (const std::string& row : rows) {
    for (const char c : row)
      labels.push_back(c >= '1' && c <= '9' ? static_cast<std::uint16_t>(c - '0') : std::uint16_t{0});
  }
  const int width = rows.empty() ? 0 : static_cast<int>(rows.front().size());
  return segmentationOf(width, static_cast<int>(rows.size()), std::move(labels));
}

void tilt(const Eigen::Vector3d& normal, double distance, SegmentedPlane& plane) {
  plane.normal = normal.normalized();
  plane.d = -plane.normal.z() * distance;
}

CameraIntrinsics outlineCamera(int width, int height) {
  const int side = std::max(width, height);
  return {0.9 * side + 7.0, 0.95 * side + 5.0, 0.5 * width - 0.7, 0.5 * height + 0.4};
}

std::vector<Polygon> ringsInImage(const Segmentation& segmentation, const SegmentedPlane& plane,
                                  const CameraIntrinsics& camera) {
  std::vector<Polygon> polygons;
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = segmentation.rings[static_cast<std::size_t>(plane.first_ring + r)];
    Polygon polygon;
    for (int i = 0; i < ring.vertex_count; ++i) {
      const Eigen::Vector3d p =
          segmentation.vertices[static_cast<std::size_t>(ring.first_vertex + i)].cast<double>();
      polygon.emplace_back(camera.fx * p.x() / p.z() + camera.cx, camera.fy * p.y() / p.z() + camera.cy);
    }
    polygons.push_back(polygon);
  }
  return polygons;
}

std::vector<Polygon> ringsOnPlane(const Segmentation& segmentation, const SegmentedPlane& plane) {
  const Eigen::Vector3d x_axis = plane.normal.unitOrthogonal(), y_axis = plane.normal.cross(x_axis);
  std::vector<Polygon> polygons;
  for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
    const Ring& ring = segmentation.rings[static_cast<std::size_t>(plane.first_ring + r)];
    Polygon polygon;
    for (int i = 0; i < ring.vertex_count; ++i) {
      const Eigen::Vector3d p =
          segmentation.vertices[static_cast<std::size_t>(ring.first_vertex + i)].cast<double>();
      polygon.emplace_back(x_axis.dot(p), y_axis.dot(p));
    }
    polygons.push_back(polygon);
  }
  return polygons;
}

double signedArea(const Polygon& ring) {
  double area = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
    area += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  return area;
}

bool isInside(const std::vector<Polygon>& rings, const Eigen::Vector2d& point) {
  bool inside = false;
  for (const Polygon& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d& a = ring[i];
      const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
      if ((a.y() > point.y()) == (b.y() > point.y())) continue;
      if (a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y()) > point.x()) inside = !inside;
    }
  }
  return inside;
}

double distanceToRing(const Polygon& ring, const Eigen::Vector2d& point) {
  double nearest = (point - ring[0]).norm();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - ring[i];
    const double position = std::clamp(along.dot(point - ring[i]) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - ring[i] - position * along).norm());
  }
  return nearest;
}

std::string faultOf(const std::vector<Polygon>& rings) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].size() < 3) return "a ring of fewer than three vertices";
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const std::size_t next = (i + 1) % rings[r].size();
      edges.push_back({rings[r][i], rings[r][next], r, i, next});
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = i + 1; k < edges.size(); ++k) {
      const Edge &a = edges[i], &b = edges[k];
      bool fault = false;
      if (a.ring == b.ring && a.next == b.index) {
        fault = foldsBack(a, b);
      } else if (a.ring == b.ring && b.next == a.index) {
        fault = foldsBack(b, a);
      } else {
        fault = meet(a, b);
      }
      if (!fault) continue;
      std::ostringstream text;
      text << "edge " << a.index << " of ring " << a.ring << " (" << a.from.transpose() << " to "
           << a.to.transpose() << ") meets edge " << b.index << " of ring " << b.ring << " ("
           << b.from.transpose() << " to " << b.to.transpose() << ")";
      return text.str();
    }
  }
  return "";
}

std::string faultOf(const Segmentation& segmentation) {
  int ring_count = 0, vertex_count = 0;
  for (const SegmentedPlane& plane : segmentation.planes) {
    const int rings = plane.outer_ring_count + plane.hole_count;
    if (plane.outer_ring_count < 0 || plane.hole_count < 0) return "negative number of rings";
    if (plane.outer_ring_count == 0 && plane.hole_count > 0) return "holes in nothing";
    if (rings > 0 && plane.first_ring != ring_count) return "rings are not plane by plane";
    if (plane.first_ring + rings > static_cast<int>(segmentation.rings.size())) return "rings out of range";
    for (int r = 0; r < rings; ++r) {
      const Ring& ring = segmentation.rings[static_cast<std::size_t>(ring_count + r)];
      if (ring.first_vertex != vertex_count || ring.vertex_count < 3) return "vertices are not ring by ring";
      vertex_count += ring.vertex_count;
      if (vertex_count > static_cast<int>(segmentation.vertices.size())) return "vertices out of range";
      for (int i = ring.first_vertex; i < vertex_count; ++i) {
        const Eigen::Vector3f& vertex = segmentation.vertices[static_cast<std::size_t>(i)];
        if (!vertex.allFinite()) return "a vertex is not finite";
        if (std::abs(plane.normal.dot(vertex.cast<double>()) + plane.d) >= 1e-5)
          return "a vertex off its plane";
      }
    }
    ring_count += rings;
  }
  if (ring_count != static_cast<int>(segmentation.rings.size())) return "rings of no plane";
  if (vertex_count != static_cast<int>(segmentation.vertices.size())) return "vertices of no ring";
  return "";
}

}  // namespace line_plane_segmentation
