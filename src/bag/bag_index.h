// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace line_plane_segmentation {

/// Returns the name of the encryption plugin of a bag of format 2.0; empty if the bag is not encrypted.
std::string encryptorOf(const std::filesystem::path& file);

/// Checks the index of a bag of format 2.0 before rosbag's library uses it: the library follows offsets and
/// sizes without comparing them with the file. Reads the headers of all records, including the messages in
/// uncompressed chunks.
/// @return description of the first problem; empty if there is none, if there is no index, and if the bag is
/// encrypted
/// @throws BadInput if the program was interrupted
std::string problemOfIndex(const std::filesystem::path& file);

}  // namespace line_plane_segmentation
