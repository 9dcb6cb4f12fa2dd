// SPDX-License-Identifier: BSD-3-Clause
#include "outline/outline.h"

#include "outline/outline_borders.h"
#include "outline/outline_projection.h"
#include "outline/outline_simplifier.h"

namespace line_plane_segmentation {
namespace {

/// A pixel has at most four corners of borders, and vertices are numbered with int.
constexpr std::size_t kMaxPixels = std::size_t{1} << 28;

bool canTrace(const CameraIntrinsics& camera, const Segmentation& segmentation) {
  if (!camera.isValid() || segmentation.width <= 0 || segmentation.height <= 0) return false;
  const std::size_t pixels =
      static_cast<std::size_t>(segmentation.width) * static_cast<std::size_t>(segmentation.height);
  return pixels <= kMaxPixels && pixels == segmentation.labels.size() && segmentation.planes.size() <= 0xFFFF;
}

}  // namespace

struct OutlineTracer::Scratch {
  /// Simplifies the borders [begin, end) of one plane and adds them to the result, all of them or, if one
  /// cannot be projected, none.
  void addRings(const Border* begin, const Border* end, const PlaneProjection& projection, double tolerance,
                SegmentedPlane& plane, Segmentation& segmentation);

  LabelRuns runs;
  BorderFollower follower;
  BorderSimplifier simplifier;
  std::vector<Eigen::Vector2d> ring;
};

void OutlineTracer::Scratch::addRings(const Border* begin, const Border* end,
                                      const PlaneProjection& projection, double tolerance,
                                      SegmentedPlane& plane, Segmentation& segmentation) {
  const std::size_t first_ring = segmentation.rings.size(), first_vertex = segmentation.vertices.size();
  const Corner* const corners = follower.corners().data();
  bool finite = true;
  for (const Border* b = begin; b != end; ++b) simplifier.add(corners + b->first, b->count);
  for (const Border* b = begin; b != end; ++b) {
    ring.clear();
    simplifier.simplify(corners + b->first, b->count, tolerance, ring);
    const std::size_t first = segmentation.vertices.size();
    finite &= projection.project(ring, segmentation.vertices);
    segmentation.rings.push_back(
        {static_cast<int>(first), static_cast<int>(segmentation.vertices.size() - first)});
    ++(b->area > 0 ? plane.outer_ring_count : plane.hole_count);
  }
  for (const Border* b = begin; b != end; ++b) simplifier.forget(corners + b->first, b->count);
  if (finite) return;
  segmentation.rings.resize(first_ring);
  segmentation.vertices.resize(first_vertex);
  plane.outer_ring_count = plane.hole_count = 0;
}

OutlineTracer::OutlineTracer() : scratch_(std::make_unique<Scratch>()) {}
OutlineTracer::~OutlineTracer() = default;

void OutlineTracer::trace(const CameraIntrinsics& camera, const OutlineParameters& parameters,
                          Segmentation& segmentation) {
  LabelRuns& runs = scratch_->runs;
  runs.clear();
  if (parameters.trace_outlines && canTrace(camera, segmentation))
    runs.scan(segmentation.labels, segmentation.width, segmentation.height);
  trace(camera, parameters, runs, segmentation);
}

void OutlineTracer::trace(const CameraIntrinsics& camera, const OutlineParameters& parameters,
                          const LabelRuns& runs, Segmentation& segmentation) {
  segmentation.rings.clear();
  segmentation.vertices.clear();
  for (SegmentedPlane& plane : segmentation.planes) {
    plane.first_ring = plane.outer_ring_count = plane.hole_count = 0;
  }
  if (!parameters.trace_outlines || !canTrace(camera, segmentation)) return;

  Scratch& s = *scratch_;
  const int width = segmentation.width, height = segmentation.height;
  const int label_count = static_cast<int>(segmentation.planes.size());
  s.follower.follow(segmentation.labels.data(), runs, width, height, label_count, parameters.min_hole_pixels);
  s.simplifier.reset(segmentation.labels.data(), width, height);

  const std::vector<Border>& borders = s.follower.borders();
  const Border* border = borders.data();
  const Border* const end = border + borders.size();
  for (int label = 1; label <= label_count; ++label) {
    SegmentedPlane& plane = segmentation.planes[label - 1];
    plane.first_ring = static_cast<int>(segmentation.rings.size());
    const Border* const first = border;
    while (border != end && border->label == label) ++border;
    const PlaneProjection projection(camera, plane, width, height);
    if (!projection.isVisible()) continue;
    s.addRings(first, border, projection, parameters.outline_tolerance, plane, segmentation);
  }
}

}  // namespace line_plane_segmentation
