// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "initialised.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Plane of the Python module, with a copy of its outline, independent of the segmentation.
struct PythonPlane {
  SegmentedPlane plane;
  std::vector<pybind11::array_t<float>> outer_rings;  ///< each n x 3
  std::vector<pybind11::array_t<float>> holes;
};

/// Segmentation of one depth image in the Python module, independent of the segmenter.
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

/// Copies a segmentation.
/// @param height, width  [px] size of the depth image, which the segmentation of an empty image does not
/// store
PythonSegmentation toPython(const Segmentation& segmentation, pybind11::ssize_t height,
                            pybind11::ssize_t width);

/// Converts the parts of a segmentation that the tracker uses: labels and planes, without outlines.
/// @throws pybind11::value_error if a label is greater than the number of planes
Segmentation fromPython(const PythonSegmentation& segmentation);

/// Transforms a plane with covariance, centroid and rings to another frame.
/// @param transform  maps points of the optical frame to the other one
PythonPlane transformed(const PythonPlane& plane, const RigidTransform& transform);

/// Returns a structured array with a row per line segment: direction (0: along a row, 1: along a column),
/// scanline, first, last, points, alpha, r, covariance.
pybind11::array lineSegmentArray(const std::vector<LineSegment>& segments);

/// Returns a structured array with a row per plane candidate: u, v, normal, d, curvature.
pybind11::array candidateArray(const std::vector<PlaneCandidate>& candidates);

/// Copies an Eigen vector or matrix to an array of one or two dimensions.
template <typename Matrix>
pybind11::array_t<double> arrayOf(const Matrix& matrix) {
  constexpr bool kIsVector = Matrix::ColsAtCompileTime == 1;
  const std::vector<pybind11::ssize_t> shape =
      kIsVector ? std::vector<pybind11::ssize_t>{matrix.rows()}
                : std::vector<pybind11::ssize_t>{matrix.rows(), matrix.cols()};
  pybind11::array_t<double> array(shape);
  double* number = array.mutable_data();
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) *number++ = matrix(row, column);
  }
  return array;
}

}  // namespace line_plane_segmentation
