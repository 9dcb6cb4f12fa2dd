// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "line_plane_segmentation/plane_tracker.h"

namespace line_plane_segmentation {

/// The values of FrameParameters::tf_fallback.
constexpr char kNoTransform[] = "none";
constexpr char kLatestTransform[] = "latest";

/// tf frames. An empty name means not used.
struct FrameParameters {
  std::string target_frame;   ///< frame of planes, markers and cloud; empty: the camera's optical frame
  std::string gravity_frame;  ///< frame whose z axis points up, for the orientation of planes
  std::string fixed_frame;    ///< static frame in which the camera's motion is measured, for the ids
  double tf_patience = 0.1;   ///< [s] longest time that an image waits for transforms
  std::string tf_fallback =
      kNoTransform;  ///< what takes the place of one that does not come: none, or the latest

  bool any() const { return !target_frame.empty() || !gravity_frame.empty() || !fixed_frame.empty(); }
};

/// Classification of planes by orientation, and the classes that are published.
struct OrientationParameters {
  double orientation_tolerance = 10.0;  ///< [deg] largest deviation of horizontal and vertical planes
  bool publish_horizontal_up = true;    ///< floors, tables
  bool publish_horizontal_down = true;  ///< ceilings
  bool publish_vertical = true;         ///< walls
  bool publish_slanted = true;          ///< all others
  bool publish_unknown = true;          ///< all planes while the direction of gravity is unknown
};

/// Calls the visitor with names and bounds, like visitParameters() for the method's parameters.
template <typename ParametersType, typename Visitor>
void visitOrientationParameters(ParametersType& p, Visitor&& visitor) {
  visitor("orientation_tolerance", p.orientation_tolerance, 0.0, 45.0);
  visitor("publish_horizontal_up", p.publish_horizontal_up, false, true);
  visitor("publish_horizontal_down", p.publish_horizontal_down, false, true);
  visitor("publish_vertical", p.publish_vertical, false, true);
  visitor("publish_slanted", p.publish_slanted, false, true);
  visitor("publish_unknown", p.publish_unknown, false, true);
}

/// Parameters of everything after the segmentation.
struct LocationParameters {
  FrameParameters frames;
  OrientationParameters orientation;
  TrackingParameters tracking;
};

}  // namespace line_plane_segmentation
