// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_arrays.h"

#include <algorithm>

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

py::array_t<float> arrayOfRing(const Segmentation& segmentation, int index) {
  const Ring& ring = segmentation.rings[static_cast<std::size_t>(index)];
  py::array_t<float> array({static_cast<py::ssize_t>(ring.vertex_count), py::ssize_t{3}});
  float* number = array.mutable_data();
  for (int i = 0; i < ring.vertex_count; ++i) {
    const Eigen::Vector3f& vertex = segmentation.vertices[static_cast<std::size_t>(ring.first_vertex + i)];
    number = std::copy_n(vertex.data(), 3, number);
  }
  return array;
}

}  // namespace

PythonSegmentation toPython(const Segmentation& segmentation) {
  PythonSegmentation result;
  result.valid_pixels = segmentation.valid_pixels;
  result.assigned_pixels = segmentation.assigned_pixels;
  result.labels = py::array_t<std::uint16_t>(
      {static_cast<py::ssize_t>(segmentation.height), static_cast<py::ssize_t>(segmentation.width)});
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

}  // namespace line_plane_segmentation
