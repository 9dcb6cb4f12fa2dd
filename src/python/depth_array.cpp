// SPDX-License-Identifier: BSD-3-Clause
#include "depth_array.h"

#include <cmath>
#include <limits>
#include <string>

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

bool isNativeOrder(const py::dtype& type) { return type.attr("isnative").cast<bool>(); }

DepthType typeOf(const py::dtype& type) {
  if (type.kind() == 'u' && type.itemsize() == 2) return DepthType::kUint16;
  if (type.kind() == 'f' && type.itemsize() == 4) return DepthType::kFloat32;
  const std::string remedy =
      type.kind() == 'f' ? "depth.astype(numpy.float32)" : "depth.astype(numpy.uint16)";
  throw py::type_error("depth must be an array of uint16 or float32, not of " +
                       type.attr("name").cast<std::string>() + "; " + remedy +
                       " converts it, if its values fit");
}

}  // namespace

py::array depthArrayOf(const py::object& depth) {
  if (!py::isinstance<py::array>(depth)) {
    throw py::type_error("depth must be a numpy array, not " +
                         py::str(py::type::of(depth).attr("__name__")).cast<std::string>());
  }
  // Only masked arrays have both attributes; this avoids importing numpy.ma.
  if (py::hasattr(depth, "mask") && py::hasattr(depth, "filled")) return depth.attr("filled")(0);
  return py::reinterpret_borrow<py::array>(depth);
}

DepthView viewOf(const py::array& depth, const std::optional<double>& depth_unit) {
  const py::dtype dtype = depth.dtype();
  const DepthType type = typeOf(dtype);
  if (depth.ndim() != 2) {
    throw py::value_error("depth must have two dimensions, height and width, not " +
                          std::to_string(depth.ndim()));
  }
  const py::ssize_t height = depth.shape(0), width = depth.shape(1);
  constexpr py::ssize_t kMost = py::ssize_t{1} << 28;
  if (width > 0 && height > kMost / width) throw py::value_error("depth has too many pixels");

  DepthView view;
  view.depth_unit = static_cast<float>(depth_unit.value_or(type == DepthType::kUint16 ? 0.001 : 1.0));
  if (!(view.depth_unit > 0.0F && std::isfinite(view.depth_unit))) {
    throw py::value_error("depth_unit must be positive");
  }
  view.type = type;
  if (width == 0 || height == 0) return view;
  if ((width > 1 && depth.strides(1) != dtype.itemsize()) ||
      (height > 1 && depth.strides(0) < width * dtype.itemsize())) {
    throw py::value_error(
        "the pixels of a row of depth must lie side by side, and its rows one after the other; "
        "numpy.ascontiguousarray(depth) is such a copy");
  }
  view.data = static_cast<const std::uint8_t*>(depth.data());
  view.width = static_cast<int>(width);
  view.height = static_cast<int>(height);
  view.step = static_cast<std::size_t>(height > 1 ? depth.strides(0) : width * dtype.itemsize());
  view.swap_bytes = !isNativeOrder(dtype);
  return view;
}

}  // namespace line_plane_segmentation
