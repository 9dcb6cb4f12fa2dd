// SPDX-License-Identifier: BSD-3-Clause
#include "polygon_fill.h"

#include <Eigen/Geometry>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <cstddef>

namespace line_plane_segmentation {
namespace {

namespace bp = boost::polygon;

constexpr double kUnitsPerMetre = 1e4;
constexpr double kLargestCoordinate = 1e5;  // [m]

using Point = bp::point_data<int>;
using Polygon = bp::polygon_data<int>;

// Coordinates in the plane, and back.
class Chart {
 public:
  explicit Chart(const Plane& plane)
      : origin_(plane.centroid.x, plane.centroid.y, plane.centroid.z),
        normal_(plane.coefficients.coef[0], plane.coefficients.coef[1], plane.coefficients.coef[2]),
        x_(normal_.unitOrthogonal()),
        y_(normal_.cross(x_)) {}

  // Returns false if a point does not fit into the units.
  bool toPolygon(const geometry_msgs::Polygon& polygon, Polygon& result) const {
    std::vector<Point> points;
    for (const geometry_msgs::Point32& point : polygon.points) {
      const Eigen::Vector3d p = Eigen::Vector3f(point.x, point.y, point.z).cast<double>() - origin_;
      const double x = x_.dot(p), y = y_.dot(p);
      // Also false for NaN.
      if (!(std::abs(x) < kLargestCoordinate && std::abs(y) < kLargestCoordinate)) return false;
      points.emplace_back(static_cast<int>(std::lround(kUnitsPerMetre * x)),
                          static_cast<int>(std::lround(kUnitsPerMetre * y)));
    }
    result.set(points.begin(), points.end());
    return points.size() >= 3;
  }

  Eigen::Vector3f toSpace(const Point& point) const {
    return (origin_ + point.x() / kUnitsPerMetre * x_ + point.y() / kUnitsPerMetre * y_).cast<float>();
  }

 private:
  Eigen::Vector3d origin_, normal_, x_, y_;
};

}  // namespace

std::vector<Triangle> fillOf(const Plane& plane) {
  const Chart chart(plane);
  bp::polygon_set_data<int> area;
  Polygon polygon;
  if (chart.toPolygon(plane.outline, polygon)) area.insert(polygon);
  for (const geometry_msgs::Polygon& part : plane.other_parts) {
    if (chart.toPolygon(part, polygon)) area.insert(polygon);
  }
  for (const geometry_msgs::Polygon& hole : plane.holes) {
    if (chart.toPolygon(hole, polygon)) area.insert(polygon, true);
  }
  std::vector<Polygon> trapezoids;
  area.get_trapezoids(trapezoids);

  std::vector<Triangle> triangles;
  for (const Polygon& trapezoid : trapezoids) {
    const std::vector<Point> corners(trapezoid.begin(), trapezoid.end());
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles.push_back(
          {chart.toSpace(corners[0]), chart.toSpace(corners[i - 1]), chart.toSpace(corners[i])});
    }
  }
  return triangles;
}

}  // namespace line_plane_segmentation
