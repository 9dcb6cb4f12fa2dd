// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "depth_topics.h"

namespace line_plane_segmentation {

/// Lists the images and clouds of a bag for an error message, with the option that selects them.
/// @param types   data types by topic; empty if unknown
/// @param topics  result of reading the bag
std::string describeTopics(const std::map<std::string, std::string>& types, const DepthTopics& topics);

/// Lists the options for segmenting images without camera_info, for an error message.
/// @param infos  topics of camera_info in the bag
std::string describeInfoOptions(const std::vector<std::string>& infos);

}  // namespace line_plane_segmentation
