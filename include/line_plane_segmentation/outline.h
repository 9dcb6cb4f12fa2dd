// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "line_plane_segmentation/camera_intrinsics.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Traces the outline of every plane of a segmentation: the border of its labelled pixels, projected
/// along the pixels' rays onto the plane and simplified.
///
/// Keeps its scratch memory: no allocation once it has seen an image as rich as this one.
class OutlineTracer {
 public:
  OutlineTracer();
  ~OutlineTracer();

  /// Fills `rings` and `vertices` of `segmentation` and the rings of each of its planes from its
  /// labels. Every ring has at least three vertices, all finite, lies on its plane and does not
  /// cross itself. A plane whose border has no such ring (a single line of pixels, say) gets none.
  void trace(const CameraIntrinsics& camera, const OutlineParameters& parameters,
             Segmentation& segmentation);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace line_plane_segmentation
