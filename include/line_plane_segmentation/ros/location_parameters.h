// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "line_plane_segmentation/plane_tracker.h"

namespace line_plane_segmentation {

/// The values of FrameParameters::tf_fallback.
constexpr char kNoTransform[] = "none";
constexpr char kLatestTransform[] = "latest";

/// The frames that planes are told in and by. Empty names: not used.
struct FrameParameters {
  std::string target_frame;   ///< planes, markers and cloud are given in it; empty = the camera's own
  std::string gravity_frame;  ///< its z axis is up: planes' orientations go by it
  std::string fixed_frame;    ///< does not move: the camera's motion is measured in it, for the ids
  double tf_patience = 0.1;   ///< [s] that an image may wait for transforms that are late, or the first
  std::string tf_fallback =
      kNoTransform;  ///< what takes the place of one that does not come: none, or the latest

  bool any() const { return !target_frame.empty() || !gravity_frame.empty() || !fixed_frame.empty(); }
};

/// How planes are told apart by orientation, and which of them are published.
struct OrientationParameters {
  double orientation_tolerance = 10.0;  ///< [deg] how far horizontal and vertical planes may be off
  bool publish_horizontal_up = true;    ///< floors, tables
  bool publish_horizontal_down = true;  ///< ceilings
  bool publish_vertical = true;         ///< walls
  bool publish_slanted = true;          ///< all others
  bool publish_unknown = true;          ///< all, while nobody knows where up is
};

/// As visitParameters() for the method's parameters: the one list of names and bounds.
template <typename ParametersType, typename Visitor>
void visitOrientationParameters(ParametersType& p, Visitor&& visitor) {
  visitor("orientation_tolerance", p.orientation_tolerance, 0.0, 45.0);
  visitor("publish_horizontal_up", p.publish_horizontal_up, false, true);
  visitor("publish_horizontal_down", p.publish_horizontal_down, false, true);
  visitor("publish_vertical", p.publish_vertical, false, true);
  visitor("publish_slanted", p.publish_slanted, false, true);
  visitor("publish_unknown", p.publish_unknown, false, true);
}

/// All that decides what is told of planes beyond the segmentation.
struct LocationParameters {
  FrameParameters frames;
  OrientationParameters orientation;
  TrackingParameters tracking;
};

}  // namespace line_plane_segmentation
