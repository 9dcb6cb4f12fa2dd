// SPDX-License-Identifier: BSD-3-Clause
#include "numeric_arguments.h"

#include <pybind11/numpy.h>

#include <cmath>
#include <string>

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr const char* kCameraHelp =
    "camera must be (fx, fy, cx, cy) or a 3x3 camera matrix K in pixels, all finite, fx and fy positive";

// Text would be read as numbers, too.
Doubles numbersOf(const py::object& argument, const std::string& problem) {
  if (py::isinstance<py::str>(argument) || argument.is_none()) throw py::type_error(problem);
  const Doubles numbers = Doubles::ensure(argument);
  if (!numbers) {
    PyErr_Clear();
    throw py::type_error(problem);
  }
  return numbers;
}

bool hasShape(const Doubles& numbers, py::ssize_t rows, py::ssize_t columns) {
  return numbers.ndim() == 2 && numbers.shape(0) == rows && numbers.shape(1) == columns;
}

}  // namespace

CameraIntrinsics intrinsicsOf(const py::object& camera) {
  const Doubles numbers = numbersOf(camera, kCameraHelp);
  CameraIntrinsics intrinsics;
  if (hasShape(numbers, 3, 3)) {
    const auto k = numbers.unchecked<2>();
    if (k(0, 1) != 0.0 || k(1, 0) != 0.0 || k(2, 0) != 0.0 || k(2, 1) != 0.0 || k(2, 2) != 1.0) {
      throw py::value_error("a camera matrix must be [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], without skew");
    }
    intrinsics = {k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
  } else if (numbers.ndim() == 1 && numbers.shape(0) == 4) {
    intrinsics = {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3)};
  } else {
    throw py::type_error(kCameraHelp);
  }
  if (!intrinsics.isValid()) throw py::value_error(kCameraHelp);
  return intrinsics;
}

RigidTransform rigidTransformOf(const py::object& matrix, const char* name) {
  const std::string problem = std::string(name) + " must be a 4x4 matrix [[R, t], [0, 0, 0, 1]]";
  const Doubles numbers = numbersOf(matrix, problem);
  if (!hasShape(numbers, 4, 4) && !hasShape(numbers, 3, 4)) throw py::value_error(problem);
  RigidTransform transform = RigidTransform::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) transform(row, column) = numbers.at(row, column);
  }
  const auto r = transform.linear();
  const bool is_rotation = transform.matrix().allFinite() && r.isUnitary(1e-6) && r.determinant() > 0.0;
  const bool has_last_row = numbers.shape(0) == 3 || (numbers.at(3, 0) == 0.0 && numbers.at(3, 1) == 0.0 &&
                                                      numbers.at(3, 2) == 0.0 && numbers.at(3, 3) == 1.0);
  if (!is_rotation || !has_last_row) throw py::value_error(problem + ", R a rotation");
  return transform;
}

Eigen::Vector3d directionOf(const py::object& vector, const char* name) {
  const std::string problem = std::string(name) + " must be three finite numbers, not all 0";
  const Doubles numbers = numbersOf(vector, problem);
  if (numbers.ndim() != 1 || numbers.shape(0) != 3) throw py::value_error(problem);
  const Eigen::Vector3d direction(numbers.at(0), numbers.at(1), numbers.at(2));
  if (!(direction.allFinite() && direction.norm() > 0.0)) throw py::value_error(problem);
  return direction.normalized();
}

}  // namespace line_plane_segmentation
