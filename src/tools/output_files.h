// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Makes a folder for results, with its parents, unless it is there.
/// @throws BadInput if it cannot be made or written to
void makeOutputFolder(const std::filesystem::path& folder);

/// The one name of a file or folder, whether it is there or not: to tell if two are the same.
std::filesystem::path wholePath(const std::filesystem::path& path);

/// Files that appear together, whole, or not at all: each is written under a temporary name beside
/// its own, and renamed by commit().
class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Takes in a file that somebody else writes, who has to be done before commit().
  /// @return the temporary name to write it under
  /// @throws BadInput if there is no folder for it, or it may not be written
  std::filesystem::path reserve(const std::filesystem::path& file);

  /// @throws BadInput if the file cannot be written
  void add(const std::filesystem::path& file, const void* bytes, std::size_t size);
  void add(const std::filesystem::path& file, const std::string& text);
  void add(const std::filesystem::path& file, const std::vector<unsigned char>& bytes);

  /// Gives every file its name; those of before under these names are replaced.
  /// @throws BadInput if one cannot be renamed
  void commit();

 private:
  std::vector<std::filesystem::path> pending_;
};

}  // namespace line_plane_segmentation
