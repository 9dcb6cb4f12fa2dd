// SPDX-License-Identifier: BSD-3-Clause
// Python's PlaneTracker.
#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "initialised.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "modules.h"
#include "numeric_arguments.h"
#include "segmentation_arrays.h"

namespace line_plane_segmentation {
namespace {

namespace py = pybind11;

TrackingParameters trackingParameters(double memory, double angle, double distance) {
  TrackingParameters parameters;
  parameters.track_memory = memory;
  parameters.track_angle = angle;
  parameters.track_distance = distance;
  visitTrackingParameters(parameters, [](const char* name, const auto& value, auto min, auto max) {
    if (!(value >= min && value <= max)) throw py::value_error(std::string(name) + " is out of bounds");
  });
  return parameters;
}

/// The tracker behind Python's class. Times that go back restart it, as they would in ROS.
class PythonTracker {
 public:
  PythonTracker(double memory, double angle, double distance)
      : tracker_(trackingParameters(memory, angle, distance)) {}

  std::vector<std::uint32_t> track(const PythonSegmentation& segmentation, const py::object& camera,
                                   double seconds, const py::object& motion) {
    if (!std::isfinite(seconds)) throw py::value_error("seconds must be finite");
    const CameraIntrinsics intrinsics = intrinsicsOf(camera);
    std::optional<RigidTransform> known_motion;
    if (!motion.is_none()) known_motion = rigidTransformOf(motion, "motion");
    if (seconds < last_seconds_) tracker_.reset();
    last_seconds_ = seconds;
    return tracker_.track(fromPython(segmentation), intrinsics, seconds,
                          known_motion ? &*known_motion : nullptr);
  }

  void reset() {
    tracker_.reset();
    last_seconds_ = -HUGE_VAL;
  }

 private:
  PlaneTracker tracker_;
  double last_seconds_ = -HUGE_VAL;
};

}  // namespace
}  // namespace line_plane_segmentation

namespace pybind11::detail {

template <>
class type_caster<line_plane_segmentation::PythonTracker>
    : public line_plane_segmentation::InitialisedCaster<line_plane_segmentation::PythonTracker> {};

}  // namespace pybind11::detail

namespace line_plane_segmentation {

void defineTracker(py::module& module) {
  const TrackingParameters defaults;
  py::class_<PythonTracker>(
      module, "PlaneTracker",
      "Gives planes ids that stay from image to image.\n\n"
      "PlaneTracker(track_memory=3.0, track_angle=45.0, track_distance=0.1)\n\n"
      "track_memory: [s] that an unseen plane keeps its id, 0 to 60.\n"
      "track_angle: [deg] that a normal may turn from image to image, 1 to 90.\n"
      "track_distance: distance of a plane from where it was expected, as a fraction of "
      "its depth, 0.001 to 10.\n\n"
      "Raises ValueError for a value that is out of bounds. Not for use by two threads at once.")
      .def(py::init<double, double, double>(), py::arg("track_memory") = defaults.track_memory,
           py::arg("track_angle") = defaults.track_angle, py::arg("track_distance") = defaults.track_distance,
           "__init__(track_memory=3.0, track_angle=45.0, track_distance=0.1)")
      .def("track", &PythonTracker::track, py::arg("segmentation"), py::arg("camera"), py::arg("seconds"),
           py::arg("motion") = py::none(),
           "track(segmentation, camera, seconds, motion=None) -> list of int\n\n"
           "The id of each plane, in the order of segmentation.planes. Ids count from 1; none is used twice, "
           "unless seconds go back or reset() is called: then they count from 1 again.\n\n"
           "segmentation: of the next image of one camera.\n"
           "camera: as for PlaneSegmenter.segment().\n"
           "seconds: [s] time of the image.\n"
           "motion: array (4, 4) that maps points of the last image's optical frame to this one's; None: "
           "unknown.\n\n"
           "Raises ValueError if motion is not a rotation and a translation, or seconds not finite.")
      .def("reset", &PythonTracker::reset,
           "reset() -> None\n\nForgets all planes, and begins again with id 1.");
}

}  // namespace line_plane_segmentation
