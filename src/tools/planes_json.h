// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Returns the planes of a frame as JSON: lengths in metres, in the camera's optical frame. For each plane,
/// "polygon" is the largest outer ring, "other_parts" are the other outer rings, and "holes" the rings of the
/// holes. Deterministic.
std::string planesJson(const std::string& frame, const Segmentation& segmentation, const StageClock& clock);

/// Same, with additional members, such as the result of provenanceOf().
std::string planesJson(const std::string& frame, const Segmentation& segmentation, const StageClock& clock,
                       const nlohmann::json& more);

}  // namespace line_plane_segmentation
