// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <mutex>
#include <optional>
#include <string>

#include "depth_array.h"
#include "initialised.h"
#include "line_plane_segmentation/palette.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "modules.h"
#include "numeric_arguments.h"
#include "segmentation_arrays.h"
#include "segmenter_help.h"

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

/// Implementation of Python's class. segment() releases the interpreter lock; threads that use the same
/// object wait for each other.
class PythonSegmenter {
 public:
  PythonSegmenter(const std::string& preset, const py::kwargs& parameters) {
    Parameters chosen;
    if (!loadPreset(preset, chosen)) {
      throw py::value_error("no preset is named '" + preset + "'; there are " + presetNames());
    }
    set(parameters, chosen);
  }

  void setParameters(const py::kwargs& parameters) {
    const Lock lock = waitForOthers();
    set(parameters, segmenter_.parameters());
  }

  py::dict parameters() const {
    const Lock lock = waitForOthers();
    py::dict values;
    visitParameters(segmenter_.parameters(), [&values](const char* name, const auto& value, auto, auto) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Method>) {
        values[name] = nameOf(value);
      } else {
        values[name] = value;
      }
    });
    return values;
  }

  PythonSegmentation segment(const py::object& depth, const py::object& camera,
                             const std::optional<double>& depth_unit,
                             const std::optional<double>& metres_per_unit) {
    if (depth_unit && metres_per_unit) {
      throw py::value_error("depth_unit and metres_per_unit are the same; give one of them");
    }
    const py::array array = depthArrayOf(depth);
    const CameraIntrinsics intrinsics = intrinsicsOf(camera);
    const DepthView view = viewOf(array, depth_unit ? depth_unit : metres_per_unit);
    const Lock lock = waitForOthers();
    return toPython(segmentWithoutPython(view, intrinsics), array.shape(0), array.shape(1));
  }

  py::array lineSegments() {
    const Lock lock = waitForOthers();
    return lineSegmentArray(segmenter_.lineSegments());
  }

  py::array candidates() {
    const Lock lock = waitForOthers();
    return candidateArray(segmenter_.candidates());
  }

  py::dict milliseconds() const {
    const Lock lock = waitForOthers();
    py::dict times;
    for (int i = 0; i < kStageCount; ++i) {
      const auto stage = static_cast<Stage>(i);
      times[nameOf(stage)] = clock_.milliseconds(stage);
    }
    times["total"] = clock_.totalMilliseconds();
    return times;
  }

 private:
  using Lock = std::unique_lock<std::mutex>;

  // The interpreter lock is released while waiting, because the thread that holds mutex_ needs it to finish.
  Lock waitForOthers() const {
    const py::gil_scoped_release release;
    return Lock(mutex_);
  }

  const Segmentation& segmentWithoutPython(const DepthView& view, const CameraIntrinsics& camera) {
    const py::gil_scoped_release release;
    return segmenter_.segment(view, camera, &clock_);
  }

  void set(const py::kwargs& given, Parameters parameters) {
    const Parameters before = parameters;
    for (const auto& [name, value] : given) {
      std::string text = py::str(value);
      // Python's and numpy's booleans.
      if (text == "True") text = "true";
      if (text == "False") text = "false";
      const std::string problem = setParameter(py::str(name), text, parameters);
      if (!problem.empty()) throw py::value_error(problem);
    }
    for (const std::string& line : changesWithoutEffect(before, parameters)) {
      if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) throw py::error_already_set();
    }
    const std::vector<std::string> changes = sanitize(parameters);
    if (!changes.empty()) throw py::value_error("these do not go together: " + changes.front());
    segmenter_.setParameters(parameters);
  }

  PlaneSegmenter segmenter_;
  StageClock clock_;
  mutable std::mutex mutex_;
};

}  // namespace
}  // namespace line_plane_segmentation

namespace pybind11::detail {

template <>
class type_caster<line_plane_segmentation::PythonSegmenter>
    : public line_plane_segmentation::InitialisedCaster<line_plane_segmentation::PythonSegmenter> {};

}  // namespace pybind11::detail

namespace line_plane_segmentation {

void defineSegmenter(py::module& module) {
  py::class_<PythonSegmenter>(module, "PlaneSegmenter", kSegmenterHelp)
      .def(py::init<const std::string&, const py::kwargs&>(), py::arg("preset") = "kinect",
           "__init__(preset='kinect', **parameters)")
      .def("segment", &PythonSegmenter::segment, py::arg("depth"), py::arg("camera"),
           py::arg("depth_unit") = py::none(), py::arg("metres_per_unit") = py::none(), kSegmentHelp)
      .def("set_parameters", &PythonSegmenter::setParameters,
           "set_parameters(**parameters) -> None\n\n"
           "Changes parameters for the images to come: set_parameters(max_range=4.0). Raises ValueError, and "
           "changes none, if one is unknown or out of bounds.")
      .def_property_readonly("parameters", &PythonSegmenter::parameters, "dict: all parameters as they are")
      .def_property_readonly("milliseconds", &PythonSegmenter::milliseconds,
                             "dict [ms]: how long each stage of the last segment() took, and 'total'")
      .def_property_readonly(
          "line_segments", &PythonSegmenter::lineSegments,
          "structured array (n,): the line segments of the last image. Fields: direction (0: along a row, 1: "
          "along a column), scanline [px] (which row or column), first and last [px], points, alpha [rad] "
          "and r [m] (s cos(alpha) + t sin(alpha) = r in the plane of camera and scanline: t is a point's "
          "coordinate along the scanline, s its distance from the camera across it), covariance (2, 2) of "
          "(alpha, r)")
      .def_property_readonly(
          "candidates", &PythonSegmenter::candidates,
          "structured array (n,): the plane candidates of the last image, before extraction. Fields: u and v "
          "[px] (column and row of the pixel), normal (3,) (unit, towards the camera) and d [m] (normal . p "
          "+ d = 0), curvature (smallest eigenvalue over the sum of all three, 0 to 1/3)");
}

}  // namespace line_plane_segmentation

PYBIND11_MODULE(_plane_segmenter, module) {
  using namespace line_plane_segmentation;
  module.doc() = "The compiled part of line_plane_segmentation.";
  module.attr("__version__") = LPS_VERSION;
  module.attr("__abi__") = LPS_ABI;
  // The texts begin with signatures in Python's terms.
  pybind11::options options;
  options.disable_function_signatures();
  definePlane(module);
  defineSegmentation(module);
  defineSegmenter(module);
  defineTracker(module);
  module.def(
      "color_of",
      [](std::uint32_t id) {
        const Color color = colorOf(id);
        return std::array<int, 3>{color.r, color.g, color.b};
      },
      pybind11::arg("id"),
      "color_of(id) -> list of 3 int\n\nThe colour (red, green, blue), each 0 to 255, of the plane with this "
      "id or "
      "label, as in all pictures of this package.");
}
