// SPDX-License-Identifier: BSD-3-Clause
// Python's Plane and Segmentation.
#include <pybind11/stl.h>

#include "line_plane_segmentation/orientation.h"
#include "modules.h"
#include "numeric_arguments.h"
#include "segmentation_arrays.h"

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

constexpr double kRightAngle = 1.5707963267948966;  // [rad]

std::string describe(const PythonPlane& p) {
  return py::str("Plane(label={}, normal=[{:.4f}, {:.4f}, {:.4f}], d={:.4f}, area={:.3f}, inliers={})")
      .format(p.plane.label, p.plane.normal.x(), p.plane.normal.y(), p.plane.normal.z(), p.plane.d,
              p.plane.area, p.plane.inliers);
}

// All that a plane consists of, as numbers and arrays: what pickle stores.
py::tuple stateOf(const PythonPlane& p) {
  return py::make_tuple(p.plane.label, arrayOf(p.plane.normal), p.plane.d, arrayOf(p.plane.centroid),
                        arrayOf(p.plane.covariance), p.plane.inliers, p.plane.rms, p.plane.area,
                        p.outer_rings, p.holes);
}

template <typename Matrix>
Matrix matrixOf(const py::handle& array) {
  const auto numbers = py::cast<py::array_t<double, py::array::c_style>>(array);
  Matrix matrix;
  if (numbers.size() != matrix.size()) throw py::value_error("not the state of a Plane");
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) {
      matrix(row, column) = numbers.data()[row * matrix.cols() + column];
    }
  }
  return matrix;
}

PythonPlane planeOf(const py::tuple& state) {
  if (state.size() != 10) throw py::value_error("not the state of a Plane");
  PythonPlane p;
  p.plane.label = state[0].cast<std::uint16_t>();
  p.plane.normal = matrixOf<Eigen::Vector3d>(state[1]);
  p.plane.d = state[2].cast<double>();
  p.plane.centroid = matrixOf<Eigen::Vector3d>(state[3]);
  p.plane.covariance = matrixOf<Covariance4d>(state[4]);
  p.plane.inliers = state[5].cast<std::uint32_t>();
  p.plane.rms = state[6].cast<double>();
  p.plane.area = state[7].cast<double>();
  p.outer_rings = state[8].cast<std::vector<py::array_t<float>>>();
  p.holes = state[9].cast<std::vector<py::array_t<float>>>();
  return p;
}

std::string orientationName(const PythonPlane& p, const py::object& up, double tolerance) {
  if (!(tolerance >= 0.0 && tolerance <= kRightAngle / 2.0)) {
    throw py::value_error("tolerance must be 0 to pi / 4");
  }
  return nameOf(orientationOf(p.plane.normal, directionOf(up, "up"), tolerance));
}

PythonSegmentation segmentationOf(const py::tuple& state) {
  if (state.size() != 4) throw py::value_error("not the state of a Segmentation");
  const auto labels = state[0].cast<py::array_t<std::uint16_t, py::array::c_style | py::array::forcecast>>();
  if (labels.ndim() != 2) throw py::value_error("not the state of a Segmentation");
  return {labels, state[1].cast<std::vector<PythonPlane>>(), state[2].cast<std::uint32_t>(),
          state[3].cast<std::uint32_t>()};
}

void defineProperties(py::class_<PythonPlane>& plane) {
  plane
      .def_property_readonly(
          "label", [](const PythonPlane& p) { return p.plane.label; },
          "int: the value of its pixels in Segmentation.labels, from 1, the largest plane first")
      .def_property_readonly(
          "normal", [](const PythonPlane& p) { return arrayOf(p.plane.normal); },
          "float64 array (3,): unit normal, towards the camera")
      .def_property_readonly(
          "d", [](const PythonPlane& p) { return p.plane.d; },
          "float [m]: distance to the camera, at least 0; after transformed(), signed distance to that "
          "frame's origin")
      .def_property_readonly(
          "covariance", [](const PythonPlane& p) { return arrayOf(p.plane.covariance); },
          "float64 array (4, 4): of (normal, d)")
      .def_property_readonly(
          "centroid", [](const PythonPlane& p) { return arrayOf(p.plane.centroid); },
          "float64 array (3,) [m]: mean of its points")
      .def_property_readonly(
          "inliers", [](const PythonPlane& p) { return p.plane.inliers; }, "int [px]: number of its pixels")
      .def_property_readonly(
          "rms", [](const PythonPlane& p) { return p.plane.rms; },
          "float [m]: root mean square orthogonal distance of its points")
      .def_property_readonly(
          "area", [](const PythonPlane& p) { return p.plane.area; },
          "float [m^2]: area of the visible surface, without holes but with small gaps in the depth, "
          "which the outlines go round")
      .def_readonly(
          "outlines", &PythonPlane::outer_rings,
          "list of float32 arrays (n, 3) [m]: the borders of its parts, the largest first, counterclockwise "
          "as the camera sees them; empty if trace_outlines is off")
      .def_readonly("holes", &PythonPlane::holes,
                    "list of float32 arrays (n, 3) [m]: the borders of the holes in its parts, clockwise");
}

}  // namespace

void definePlane(py::module& module) {
  py::class_<PythonPlane> plane(
      module, "Plane",
      "A plane: all points p with normal . p + d = 0, in the camera's optical frame (x right, y "
      "down, z forward), in metres. Can be pickled.");
  defineProperties(plane);
  plane
      .def(
          "transformed",
          [](const PythonPlane& p, const py::object& pose) {
            return transformed(p, rigidTransformOf(pose, "pose"));
          },
          py::arg("pose"),
          "transformed(pose) -> Plane\n\n"
          "The plane in another frame, with covariance, centroid and outlines. The normal still points "
          "toward "
          "the camera.\n\n"
          "pose: array (4, 4) that maps points of the camera's optical frame to the other frame: the "
          "camera's "
          "pose there.\n\n"
          "Raises ValueError if pose is not a rotation and a translation.")
      .def("orientation", &orientationName, py::arg("up"), py::arg("tolerance") = kRightAngle / 9.0,
           "orientation(up, tolerance=0.1745) -> str\n\n"
           "Orientation relative to gravity: 'horizontal_up' (a floor, a table), 'horizontal_down' (a "
           "ceiling), 'vertical' "
           "(a wall) or 'slanted'.\n\n"
           "up: three numbers, the direction against gravity in the plane's frame, of any length.\n"
           "tolerance: [rad] from 0 to pi / 4, deviation of a horizontal or vertical plane.\n\n"
           "Raises ValueError if up is zero or not finite, or tolerance is out of its range.")
      .def("__repr__", &describe)
      .def(py::pickle(&stateOf, &planeOf));
}

void defineSegmentation(py::module& module) {
  py::class_<PythonSegmentation>(module, "Segmentation",
                                 "The planes and labels of one depth image. Can be pickled.")
      .def_readonly("labels", &PythonSegmentation::labels,
                    "uint16 array (height, width): 0 = no plane, k = planes[k - 1]")
      .def_readonly("planes", &PythonSegmentation::planes, "list of Plane, the largest first")
      .def_readonly("valid_pixels", &PythonSegmentation::valid_pixels, "int: pixels with a depth in range")
      .def_readonly("assigned_pixels", &PythonSegmentation::assigned_pixels, "int: pixels of planes")
      .def("__repr__",
           [](const PythonSegmentation& s) {
             return py::str("Segmentation({} planes, {}x{} pixels)")
                 .format(s.planes.size(), s.labels.shape(1), s.labels.shape(0));
           })
      .def(py::pickle(
          [](const PythonSegmentation& s) {
            return py::make_tuple(s.labels, s.planes, s.valid_pixels, s.assigned_pixels);
          },
          &segmentationOf));
}

}  // namespace line_plane_segmentation
