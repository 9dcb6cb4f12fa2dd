// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <line_plane_segmentation/PlaneArray.h>

#include <filesystem>
#include <string>

#include "output_files.h"

namespace line_plane_segmentation {

/// CSV table with one row per plane: topic of the image and values of the plane's message.
class PlanesCsv {
 public:
  /// Adds the table with its header to `files`, which must outlive this object.
  /// @throws BadInput if the file cannot be written
  PlanesCsv(OutputFiles& files, const std::filesystem::path& file);

  /// Appends the planes of an image.
  /// @throws BadInput if the table cannot be written
  void add(const std::string& topic, const PlaneArray& planes);

 private:
  OutputFiles& files_;
  std::filesystem::path file_;
};

}  // namespace line_plane_segmentation
