// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <mutex>
#include <optional>
#include <string>

#include "depth_array.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/stage_clock.h"
#include "segmentation_arrays.h"

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

/// The segmenter behind Python's class. Other Python threads go on while it works; those that share it wait.
class PythonSegmenter {
 public:
  PythonSegmenter(const std::string& preset, const py::kwargs& parameters) {
    Parameters chosen;
    if (!loadPreset(preset, chosen)) {
      throw py::value_error("no preset is named '" + preset + "'; there are kinect, short_range and paper");
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
        values[name] = value == Method::kPaper ? "paper" : "adaptive";
      } else {
        values[name] = value;
      }
    });
    return values;
  }

  PythonSegmentation segment(const py::array& depth, const std::array<double, 4>& camera,
                             const std::optional<double>& metres_per_unit) {
    const CameraIntrinsics intrinsics{camera[0], camera[1], camera[2], camera[3]};
    if (!intrinsics.isValid()) {
      throw py::value_error("camera must be (fx, fy, cx, cy) in pixels, all finite, fx and fy positive");
    }
    const DepthView view = viewOf(depth, metres_per_unit);
    const Lock lock = waitForOthers();
    return toPython(segmentWithoutPython(view, intrinsics));
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

  // Who waits for another thread here must not hold Python's own lock: the other one needs it to come to its
  // end.
  Lock waitForOthers() const {
    const py::gil_scoped_release let_others_go_on;
    return Lock(mutex_);
  }

  const Segmentation& segmentWithoutPython(const DepthView& view, const CameraIntrinsics& camera) {
    const py::gil_scoped_release let_others_go_on;
    return segmenter_.segment(view, camera, &clock_);
  }

  void set(const py::kwargs& given, Parameters parameters) {
    for (const auto& [name, value] : given) {
      std::string text = py::str(value);
      if (py::isinstance<py::bool_>(value)) text = value.cast<bool>() ? "true" : "false";
      const std::string problem = setParameter(py::str(name), text, parameters);
      if (!problem.empty()) throw py::value_error(problem);
    }
    const std::vector<std::string> changes = sanitize(parameters);
    if (!changes.empty()) throw py::value_error("these do not go together: " + changes.front());
    segmenter_.setParameters(parameters);
  }

  PlaneSegmenter segmenter_;
  StageClock clock_;
  mutable std::mutex mutex_;
};

std::string describe(const PythonPlane& p) {
  return py::str("Plane(label={}, normal=[{:.4f}, {:.4f}, {:.4f}], d={:.4f}, area={:.3f}, inliers={})")
      .format(p.plane.label, p.plane.normal.x(), p.plane.normal.y(), p.plane.normal.z(), p.plane.d,
              p.plane.area, p.plane.inliers);
}

void definePlane(py::module& module) {
  py::class_<PythonPlane>(
      module, "Plane",
      "A plane: all points p with normal . p + d = 0, in the camera's optical frame (x right, y "
      "down, z ahead), in metres.")
      .def_property_readonly(
          "label", [](const PythonPlane& p) { return p.plane.label; },
          "int: the value of its pixels in Segmentation.labels, from 1, the largest plane first")
      .def_property_readonly(
          "normal", [](const PythonPlane& p) { return arrayOf(p.plane.normal); },
          "float64 array (3,): unit, toward the camera")
      .def_property_readonly(
          "d", [](const PythonPlane& p) { return p.plane.d; },
          "float [m]: distance to the camera, not negative")
      .def_property_readonly(
          "covariance", [](const PythonPlane& p) { return arrayOf(p.plane.covariance); },
          "float64 array (4, 4): of (normal, d)")
      .def_property_readonly(
          "centroid", [](const PythonPlane& p) { return arrayOf(p.plane.centroid); },
          "float64 array (3,) [m]: mean of its points")
      .def_property_readonly(
          "inliers", [](const PythonPlane& p) { return p.plane.inliers; }, "int [px]: its pixels")
      .def_property_readonly(
          "rms", [](const PythonPlane& p) { return p.plane.rms; },
          "float [m]: root mean square distance of its points to it")
      .def_property_readonly(
          "area", [](const PythonPlane& p) { return p.plane.area; },
          "float [m^2]: visible surface, holes left out")
      .def_readonly(
          "outlines", &PythonPlane::outer_rings,
          "list of float32 arrays (n, 3) [m]: the borders of its parts, the largest first, counterclockwise "
          "as the camera sees them; empty if trace_outlines is off")
      .def_readonly("holes", &PythonPlane::holes,
                    "list of float32 arrays (n, 3) [m]: the borders of the holes in its parts, clockwise")
      .def("__repr__", &describe);
}

void defineSegmentation(py::module& module) {
  py::class_<PythonSegmentation>(module, "Segmentation", "What one depth image was cut into.")
      .def_readonly("labels", &PythonSegmentation::labels,
                    "uint16 array (height, width): 0 = no plane, k = planes[k - 1]")
      .def_readonly("planes", &PythonSegmentation::planes, "list of Plane, the largest first")
      .def_readonly("valid_pixels", &PythonSegmentation::valid_pixels, "int: pixels with a depth in range")
      .def_readonly("assigned_pixels", &PythonSegmentation::assigned_pixels, "int: pixels of planes")
      .def("__repr__", [](const PythonSegmentation& s) {
        return py::str("Segmentation({} planes, {}x{} pixels)")
            .format(s.planes.size(), s.labels.shape(1), s.labels.shape(0));
      });
}

void defineSegmenter(py::module& module) {
  py::class_<PythonSegmenter>(
      module, "PlaneSegmenter",
      "Finds the planes of depth images.\n\n"
      "PlaneSegmenter(preset='kinect', **parameters)\n\n"
      "preset: 'kinect' (also Xtion and the like), 'short_range' (scanners with millimetre steps), or "
      "'paper' (the "
      "published method to the letter). parameters: any of those that the property parameters shows, such as "
      "max_range=4.0; what each means is in cfg/PlaneSegmenter.cfg.\n\n"
      "Raises ValueError for an unknown preset or parameter, and for a value that is out of bounds.\n\n"
      "The same image gives the same result, bit by bit. Threads may share one, but then wait for each "
      "other: better "
      "give each its own.")
      .def(py::init<const std::string&, const py::kwargs&>(), py::arg("preset") = "kinect")
      .def("segment", &PythonSegmenter::segment, py::arg("depth").noconvert(), py::arg("camera"),
           py::arg("metres_per_unit") = py::none(),
           "Segments one image.\n\n"
           "depth: array (height, width) of the depths along the optical axis, uint16 (0 = none) or float32 "
           "(anything "
           "but a positive finite number = none). It is not copied: rows may be apart, as in a slice, but "
           "the pixels "
           "of a row must lie side by side. Do not write into it meanwhile.\n"
           "camera: (fx, fy, cx, cy) [px] of these pixels; the centre of the first pixel is (0, 0).\n"
           "metres_per_unit: [m] of the number 1 in depth; by default 0.001 for uint16 and 1 for float32.\n\n"
           "Returns a Segmentation, which stays as it is when the next image is segmented.\n\n"
           "Raises TypeError if depth is of another type, ValueError if it has not two dimensions or its "
           "pixels lie "
           "apart, or if camera or metres_per_unit cannot be.")
      .def("set_parameters", &PythonSegmenter::setParameters,
           "Changes parameters for the images to come: set_parameters(max_range=4.0). Raises ValueError, and "
           "changes "
           "none, if one is unknown or out of bounds.")
      .def_property_readonly("parameters", &PythonSegmenter::parameters, "dict: all parameters as they are")
      .def_property_readonly("milliseconds", &PythonSegmenter::milliseconds,
                             "dict [ms]: what each stage of the last image took, and 'total'");
}

}  // namespace
}  // namespace line_plane_segmentation

PYBIND11_MODULE(_plane_segmenter, module) {
  using namespace line_plane_segmentation;
  module.doc() = "The compiled part of line_plane_segmentation.";
  definePlane(module);
  defineSegmentation(module);
  defineSegmenter(module);
}
