// SPDX-License-Identifier: BSD-3-Clause
#include "planes_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace line_plane_segmentation {
namespace {

using nlohmann::json;

json toJson(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

// A float written as a double shows nine digits that it does not have; a micrometre is enough.
double roundToMicrometre(float metres) { return std::round(static_cast<double>(metres) * 1e6) / 1e6; }

json ringToJson(const Segmentation& segmentation, int index) {
  const Ring& ring = segmentation.rings[index];
  json vertices = json::array();
  for (int i = 0; i < ring.vertex_count; ++i) {
    const Eigen::Vector3f& vertex = segmentation.vertices[ring.first_vertex + i];
    vertices.push_back(
        {roundToMicrometre(vertex.x()), roundToMicrometre(vertex.y()), roundToMicrometre(vertex.z())});
  }
  return vertices;
}

json ringsToJson(const Segmentation& segmentation, int first, int end) {
  json rings = json::array();
  for (int i = first; i < end; ++i) rings.push_back(ringToJson(segmentation, i));
  return rings;
}

json planeToJson(const Segmentation& segmentation, const SegmentedPlane& plane) {
  const int first_hole = plane.first_ring + plane.outer_ring_count;
  const bool has_outline = plane.outer_ring_count > 0;
  return {{"label", plane.label},
          {"normal", toJson(plane.normal)},
          {"d", plane.d},
          {"centroid", toJson(plane.centroid)},
          {"inliers", plane.inliers},
          {"rms", plane.rms},
          {"area", plane.area},
          {"polygon", has_outline ? ringToJson(segmentation, plane.first_ring) : json::array()},
          {"other_parts", ringsToJson(segmentation, plane.first_ring + 1, first_hole)},
          {"holes", ringsToJson(segmentation, first_hole, first_hole + plane.hole_count)}};
}

json document(const std::string& frame, const Segmentation& segmentation, const StageClock& clock) {
  json planes = json::array();
  for (const SegmentedPlane& plane : segmentation.planes) planes.push_back(planeToJson(segmentation, plane));

  json milliseconds;
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    milliseconds[nameOf(stage)] = clock.milliseconds(stage);
  }
  milliseconds["total"] = clock.totalMilliseconds();
  return {{"frame", frame}, {"planes", planes}, {"milliseconds", milliseconds}};
}

// A file's name need not be UTF-8, JSON must be.
std::string textOf(const json& document) {
  return document.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string planesJson(const std::string& frame, const Segmentation& segmentation, const StageClock& clock) {
  return textOf(document(frame, segmentation, clock));
}

std::string planesJson(const std::string& frame, const Segmentation& segmentation, const StageClock& clock,
                       const json& more) {
  json all = document(frame, segmentation, clock);
  all.update(more);
  return textOf(all);
}

}  // namespace line_plane_segmentation
