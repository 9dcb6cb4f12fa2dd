// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace line_plane_segmentation {

/// Returns the name of what a bag of format 2.0 is encrypted with; empty if it is not.
std::string encryptorOf(const std::filesystem::path& file);

/// Checks the index of a bag of format 2.0 before rosbag's library reads by it: that library follows offsets
/// and sizes without comparing them with the file. Reads the heads of all records; of messages in chunks
/// without compression, too.
/// @return what is wrong, in a few words; empty if nothing is, if there is no index, and if the bag is
/// encrypted
/// @throws BadInput if the program was asked to end
std::string problemOfIndex(const std::filesystem::path& file);

}  // namespace line_plane_segmentation
