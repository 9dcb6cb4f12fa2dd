// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Makes a folder for results, with its parents, unless it exists.
/// @throws BadInput if it cannot be made or written to
void makeOutputFolder(const std::filesystem::path& folder);

/// Returns the absolute path of a file or folder without symbolic links, whether it exists or not. Two names
/// of the same file have the same absolute path, except for hard links.
std::filesystem::path wholePath(const std::filesystem::path& path);

/// Returns whether a file cannot be written in any order: a FIFO, or a name of a file that is open already,
/// such as /dev/stdout.
bool isStream(const std::filesystem::path& file);

/// Files that appear together, whole, or not at all. The content goes into unnamed files of the same file
/// system (O_TMPFILE). commit() writes them to the disk (fsync) and names them. A process that ends before,
/// by whatever signal, leaves nothing behind. Where the file system has no unnamed files, uniquely named ones
/// take their place.
///
/// A symbolic link stays, its target is replaced. A character device or a FIFO, such as /dev/stdout, is
/// written to. All other special files are refused.
class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Names a file that no output may replace. Hard links and symbolic links to it are recognised.
  void protect(const std::filesystem::path& input);

  /// @throws BadInput if an output of this name would replace a protected file
  void checkProtected(const std::filesystem::path& file) const;

  /// Adds a file that the caller writes by name, and has to close before commit().
  /// @return the name under which the content is to be written, valid in this process
  /// @throws BadInput if the folder does not exist, the file may not be written, is protected, or was added
  /// before
  std::filesystem::path reserve(const std::filesystem::path& file);

  /// Adds a file with this content.
  /// @throws BadInput as reserve(), or if the content cannot be written
  void add(const std::filesystem::path& file, const void* bytes, std::size_t size);
  void add(const std::filesystem::path& file, const std::string& text);
  void add(const std::filesystem::path& file, const std::vector<unsigned char>& bytes);

  /// Continues the content of a file that was added.
  /// @throws BadInput if it cannot be written
  void append(const std::filesystem::path& file, const std::string& text);

  /// Writes everything to the disk, then names every file and replaces previous files of these names.
  /// @throws BadInput if a file cannot be written
  void commit();

 private:
  struct Pending {
    std::filesystem::path file;       ///< as the caller named it, for messages
    std::filesystem::path target;     ///< without symbolic links
    std::filesystem::path temporary;  ///< name of the content's file; empty if unnamed
    int descriptor = -1;              ///< of the content's file, or of the device
    bool is_device = false;
  };

  Pending& open(const std::filesystem::path& file);
  std::vector<std::filesystem::path> protected_;
  std::vector<Pending> pending_;
};

}  // namespace line_plane_segmentation
