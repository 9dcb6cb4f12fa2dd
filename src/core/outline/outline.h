// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"
#include "refine/label_runs.h"

namespace line_plane_segmentation {

/// Traces the outline of every plane of a segmentation: the border of its labelled pixels, simplified,
/// and projected along the pixels' rays onto the plane.
///
/// What is promised of the rings:
/// - They are simple polygons. No ring touches itself or another one of its plane: where two pixels touch
///   at a corner only, they count as apart, and the two corners are drawn in by 1/8 px each.
/// - Outer rings run counterclockwise as the camera sees them. In the image, where v points down, that is
///   downward along the left side, then to the right along the lower side; on the plane it is by the
///   right-hand rule about its normal, which points toward the camera. Holes run the other way.
/// - Of each plane come first the outer rings of its parts, then its holes, both sorted by the area that
///   they enclose in the image, the largest first.
/// - All of the border is within `outline_tolerance` [px] of its ring as the image shows it, give or take
///   what corners are drawn in by.
/// - Left out are holes that enclose fewer than `min_hole_pixels` pixels, and parts that do, except for the
///   plane's largest.
/// - Every vertex is finite and on its plane. Where pixels look past the plane's horizon, or along the plane
///   within about a degree, vertices move to where it is still seen: none is deeper than 100 times the
///   plane's distance.
///
/// The time is linear in the number of pixels, times the logarithm of the longest border, whatever the labels
/// are. Keeps its scratch memory: no allocation once it has seen an image as rich as this one.
class OutlineTracer {
 public:
  OutlineTracer();
  ~OutlineTracer();

  /// Fills `rings` and `vertices` of `segmentation`, and `first_ring`, `outer_ring_count` and `hole_count` of
  /// each of its planes, from its labels. Labels without a plane are ignored. There are no rings if outlines
  /// are switched off, if the camera is invalid or the labels do not fill the image, or it is larger than
  /// 2^28 pixels; a plane has none if the camera does not see its front.
  void trace(const CameraIntrinsics& camera, const OutlineParameters& parameters, Segmentation& segmentation);

  /// The same for who has the runs that the labels were written from; saves looking for them.
  /// @param runs  of the labels, covering the image; neighbours in a row may have the same label
  void trace(const CameraIntrinsics& camera, const OutlineParameters& parameters, const LabelRuns& runs,
             Segmentation& segmentation);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace line_plane_segmentation
