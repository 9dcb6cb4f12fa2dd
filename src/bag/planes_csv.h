// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>

#include <filesystem>
#include <string>

#include "output_files.h"

namespace line_plane_segmentation {

/// CSV table with one row per plane: the values of its message, and the topic of its image.
class PlanesCsv {
 public:
  /// Adds the table to these files.
  /// @throws BadInput if it cannot be written
  PlanesCsv(OutputFiles& files, const std::filesystem::path& file);

  /// @throws BadInput if the table cannot be written
  void add(const std::string& topic, const PlaneArray& planes);

 private:
  OutputFiles& files_;
  std::filesystem::path file_;
};

}  // namespace line_plane_segmentation
