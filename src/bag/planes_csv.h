// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace line_plane_segmentation {

/// CSV table with one row per plane: the values of its message, and the topic of its image.
class PlanesCsv {
 public:
  /// @throws BadInput if the file cannot be written
  explicit PlanesCsv(const std::filesystem::path& file);

  void add(const std::string& topic, const PlaneArray& planes);

  /// @throws BadInput if writing failed
  void close();

 private:
  std::ofstream stream_;
};

}  // namespace line_plane_segmentation
