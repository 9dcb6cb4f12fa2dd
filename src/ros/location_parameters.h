// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "line_plane_segmentation/plane_tracker.h"

namespace line_plane_segmentation {

/// Values of FrameParameters::tf_fallback.
constexpr char kNoTransform[] = "none";
constexpr char kLatestTransform[] = "latest";

/// tf frames, and how long images wait for their transforms. An empty name disables the function of a frame.
struct FrameParameters {
  /// [-] tf frame of the published planes, markers and clouds; empty = the camera's optical frame.
  std::string target_frame;
  /// [-] tf frame whose z axis points up, for the orientation of planes; empty = orientations are
  /// unknown.
  std::string gravity_frame;
  /// [-] Static tf frame in which the camera's motion is measured, for the ids; empty = ids are
  /// matched in the images alone.
  std::string fixed_frame;
  /// [s] Longest time that an image waits for transforms. Increase to lose fewer images to late
  /// transforms; decrease to limit the delay.
  double tf_patience = 0.1;
  /// [-] Replacement of a transform that does not arrive: none (the image is refused, or has no
  /// orientations or no motion), or latest, the newest known transform, which is wrong by the
  /// camera's motion since.
  std::string tf_fallback = kNoTransform;

  bool any() const { return !target_frame.empty() || !gravity_frame.empty() || !fixed_frame.empty(); }
};

/// Classification of planes by orientation, and the classes that are published.
struct OrientationParameters {
  /// [deg] Largest deviation of a horizontal or vertical plane from its exact direction. Increase
  /// to classify ramps as floors; decrease to classify them as slanted.
  double orientation_tolerance = 10.0;
  /// [-] Publish floors and tables. Switch off to leave them out of all outputs.
  bool publish_horizontal_up = true;
  /// [-] Publish ceilings. Switch off to leave them out of all outputs.
  bool publish_horizontal_down = true;
  /// [-] Publish walls. Switch off to leave them out of all outputs.
  bool publish_vertical = true;
  /// [-] Publish slanted planes. Switch off to leave them out of all outputs.
  bool publish_slanted = true;
  /// [-] Publish planes while the direction of gravity is unknown. Switch off to publish none in
  /// that case.
  bool publish_unknown = true;
};

/// Calls `visitor(name, value, min, max)` for each parameter, as visitParameters() does for the method's.
template <typename ParametersType, typename Visitor>
void visitOrientationParameters(ParametersType& p, Visitor&& visitor) {
  visitor("orientation_tolerance", p.orientation_tolerance, 0.0, 45.0);
  visitor("publish_horizontal_up", p.publish_horizontal_up, false, true);
  visitor("publish_horizontal_down", p.publish_horizontal_down, false, true);
  visitor("publish_vertical", p.publish_vertical, false, true);
  visitor("publish_slanted", p.publish_slanted, false, true);
  visitor("publish_unknown", p.publish_unknown, false, true);
}

/// Parameters of the steps after the segmentation: frames, orientation and ids.
struct LocationParameters {
  FrameParameters frames;
  OrientationParameters orientation;
  TrackingParameters tracking;
};

}  // namespace line_plane_segmentation
