// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "initialised.h"
#include "line_plane_segmentation/line_segment.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// A plane as Python sees it: with its outline, and independent of the segmentation that it is of.
struct PythonPlane {
  SegmentedPlane plane;
  std::vector<pybind11::array_t<float>> outer_rings;  ///< each n x 3
  std::vector<pybind11::array_t<float>> holes;
};

/// What one depth image was cut into, as Python sees it.
struct PythonSegmentation {
  pybind11::array_t<std::uint16_t> labels;  ///< height x width
  std::vector<PythonPlane> planes;
  std::uint32_t valid_pixels = 0;
  std::uint32_t assigned_pixels = 0;
};

}  // namespace line_plane_segmentation

namespace pybind11::detail {

template <>
class type_caster<line_plane_segmentation::PythonPlane>
    : public line_plane_segmentation::InitialisedCaster<line_plane_segmentation::PythonPlane> {};

template <>
class type_caster<line_plane_segmentation::PythonSegmentation>
    : public line_plane_segmentation::InitialisedCaster<line_plane_segmentation::PythonSegmentation> {};

}  // namespace pybind11::detail

namespace line_plane_segmentation {

/// Copies all of a segmentation.
/// @param height, width  [px] of the depth image, which a segmentation of an empty one does not have
PythonSegmentation toPython(const Segmentation& segmentation, pybind11::ssize_t height,
                            pybind11::ssize_t width);

/// Copies the parts of a segmentation that the tracker needs: labels and planes, without outlines.
/// @throws pybind11::value_error if a label is greater than the number of planes
Segmentation fromPython(const PythonSegmentation& segmentation);

/// The plane, its covariance, centroid and rings in another frame.
/// @param transform  maps points of the optical frame to the other one
PythonPlane transformed(const PythonPlane& plane, const RigidTransform& transform);

/// A structured array with a row for each line segment: direction (0: along a row, 1: a column), scanline,
/// first, last, points, alpha, r, covariance.
pybind11::array lineSegmentArray(const std::vector<LineSegment>& segments);

/// An array of one or two dimensions with the numbers of an Eigen vector or matrix.
template <typename Matrix>
pybind11::array_t<double> arrayOf(const Matrix& matrix) {
  constexpr bool is_vector = Matrix::ColsAtCompileTime == 1;
  const std::vector<pybind11::ssize_t> shape =
      is_vector ? std::vector<pybind11::ssize_t>{matrix.rows()}
                : std::vector<pybind11::ssize_t>{matrix.rows(), matrix.cols()};
  pybind11::array_t<double> array(shape);
  double* number = array.mutable_data();
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) *number++ = matrix(row, column);
  }
  return array;
}

}  // namespace line_plane_segmentation
