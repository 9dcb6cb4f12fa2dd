// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "depth_topics.h"

namespace line_plane_segmentation {

/// Describes what a bag holds of cameras, and which option of segment_bag makes use of it.
/// @param types   data types by topic; empty if they are not known
/// @param topics  what was found in the images that were read
std::string describeTopics(const std::map<std::string, std::string>& types, const DepthTopics& topics);

/// Describes how images without camera_info can be segmented.
/// @param infos  topics of camera_info that are there
std::string adviseOnInfos(const std::vector<std::string>& infos);

}  // namespace line_plane_segmentation
