// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "line_plane_segmentation/segmentation.h"
#include "line_plane_segmentation/stage_clock.h"

namespace line_plane_segmentation {

/// The planes of a frame as JSON text: lengths in metres, in the camera's optical frame. Of each plane
/// "polygon" is its largest outer ring, "other_parts" further outer rings, "holes" the rings of its holes.
/// The same planes and times give the same text.
std::string planesJson(const std::string& frame, const Segmentation& segmentation, const StageClock& clock);

/// The same, with more members: an object such as provenanceOf() returns.
std::string planesJson(const std::string& frame, const Segmentation& segmentation, const StageClock& clock,
                       const nlohmann::json& more);

}  // namespace line_plane_segmentation
