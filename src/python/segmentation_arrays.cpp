// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_arrays.h"

#include <algorithm>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

py::array_t<float> arrayOfRing(const Segmentation& segmentation, int index) {
  const Ring& ring = segmentation.rings[index];
  py::array_t<float> array({static_cast<py::ssize_t>(ring.vertex_count), py::ssize_t{3}});
  float* number = array.mutable_data();
  for (int i = 0; i < ring.vertex_count; ++i) {
    const Eigen::Vector3f& vertex = segmentation.vertices[ring.first_vertex + i];
    number = std::copy_n(vertex.data(), 3, number);
  }
  return array;
}

std::vector<py::array_t<float>> transformedRings(const std::vector<py::array_t<float>>& rings,
                                                 const RigidTransform& transform) {
  std::vector<py::array_t<float>> result;
  for (const py::array_t<float>& ring : rings) {
    py::array_t<float> moved({ring.shape(0), py::ssize_t{3}});
    for (py::ssize_t i = 0; i < ring.shape(0); ++i) {
      const Eigen::Vector3d point(ring.at(i, 0), ring.at(i, 1), ring.at(i, 2));
      const Eigen::Vector3f there = (transform * point).cast<float>();
      std::copy_n(there.data(), 3, moved.mutable_data(i, 0));
    }
    result.push_back(std::move(moved));
  }
  return result;
}

/// Row of the array of line segments.
struct LineRow {
  std::uint8_t direction;
  std::int32_t scanline, first, last, points;
  double alpha, r;
  double covariance[2][2];
};

/// Row of the array of plane candidates.
struct CandidateRow {
  std::int32_t u, v;
  double normal[3];
  double d, curvature;
};

}  // namespace

PythonSegmentation toPython(const Segmentation& segmentation, py::ssize_t height, py::ssize_t width) {
  PythonSegmentation result;
  result.valid_pixels = segmentation.valid_pixels;
  result.assigned_pixels = segmentation.assigned_pixels;
  result.labels = py::array_t<std::uint16_t>({height, width});
  std::copy(segmentation.labels.begin(), segmentation.labels.end(), result.labels.mutable_data());
  for (const SegmentedPlane& plane : segmentation.planes) {
    PythonPlane copy{plane, {}, {}};
    for (int r = 0; r < plane.outer_ring_count + plane.hole_count; ++r) {
      (r < plane.outer_ring_count ? copy.outer_rings : copy.holes)
          .push_back(arrayOfRing(segmentation, plane.first_ring + r));
    }
    result.planes.push_back(std::move(copy));
  }
  return result;
}

Segmentation fromPython(const PythonSegmentation& segmentation) {
  Segmentation result;
  result.height = static_cast<int>(segmentation.labels.shape(0));
  result.width = static_cast<int>(segmentation.labels.shape(1));
  result.labels.assign(segmentation.labels.data(), segmentation.labels.data() + segmentation.labels.size());
  for (const PythonPlane& plane : segmentation.planes) result.planes.push_back(plane.plane);
  // Python's array of labels can be written to.
  const auto largest = std::max_element(result.labels.begin(), result.labels.end());
  if (largest != result.labels.end() && *largest > result.planes.size()) {
    throw py::value_error("a label has no plane");
  }
  result.valid_pixels = segmentation.valid_pixels;
  result.assigned_pixels = segmentation.assigned_pixels;
  return result;
}

PythonPlane transformed(const PythonPlane& plane, const RigidTransform& transform) {
  return {transformed(plane.plane, transform), transformedRings(plane.outer_rings, transform),
          transformedRings(plane.holes, transform)};
}

py::array lineSegmentArray(const std::vector<LineSegment>& segments) {
  // numpy accepts the registration of a type once only.
  [[maybe_unused]] static const bool kRegistered = [] {
    PYBIND11_NUMPY_DTYPE(LineRow, direction, scanline, first, last, points, alpha, r, covariance);
    return true;
  }();
  py::array_t<LineRow> rows(static_cast<py::ssize_t>(segments.size()));
  LineRow* row = rows.mutable_data();
  for (const LineSegment& s : segments) {
    *row++ = {static_cast<std::uint8_t>(s.direction == ScanDirection::kRow ? 0 : 1),
              s.scanline,
              s.first,
              s.last,
              s.points,
              s.alpha,
              s.r,
              {{s.covariance(0, 0), s.covariance(0, 1)}, {s.covariance(1, 0), s.covariance(1, 1)}}};
  }
  return std::move(rows);
}

py::array candidateArray(const std::vector<PlaneCandidate>& candidates) {
  [[maybe_unused]] static const bool kRegistered = [] {
    PYBIND11_NUMPY_DTYPE(CandidateRow, u, v, normal, d, curvature);
    return true;
  }();
  py::array_t<CandidateRow> rows(static_cast<py::ssize_t>(candidates.size()));
  CandidateRow* row = rows.mutable_data();
  for (const PlaneCandidate& c : candidates) {
    *row++ = {c.u, c.v, {c.normal.x(), c.normal.y(), c.normal.z()}, c.d, c.curvature};
  }
  return std::move(rows);
}

}  // namespace line_plane_segmentation
