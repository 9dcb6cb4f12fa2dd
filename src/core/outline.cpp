// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/outline.h"

namespace line_plane_segmentation {

struct OutlineTracer::Scratch {};

OutlineTracer::OutlineTracer() : scratch_(std::make_unique<Scratch>()) {}
OutlineTracer::~OutlineTracer() = default;

void OutlineTracer::trace(const CameraIntrinsics&, const OutlineParameters&, Segmentation& segmentation) {
  segmentation.rings.clear();
  segmentation.vertices.clear();
}

}  // namespace line_plane_segmentation
