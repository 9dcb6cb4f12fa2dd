// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace line_plane_segmentation {

/// Creates a folder for results, with its parents, unless it exists.
/// @throws BadInput if it cannot be created or is not writable
void makeOutputFolder(const std::filesystem::path& folder);

/// Returns the absolute path of a file or folder without symbolic links, whether it exists or not. Two names
/// of the same file have the same absolute path, except for hard links.
std::filesystem::path wholePath(const std::filesystem::path& path);

/// Returns true if a file supports sequential writing only: a FIFO or an open file such as /dev/stdout.
bool isStream(const std::filesystem::path& file);

/// Atomic output of several files: they appear complete and together, or not at all. The content is written
/// to unnamed files of the same file system (O_TMPFILE). commit() flushes them to the disk (fsync) and names
/// them. A process that is killed before leaves no files. If the file system does not support unnamed files,
/// files with unique names are used.
///
/// If an output is a symbolic link, its target is replaced. Character devices and FIFOs, such as /dev/stdout,
/// are written directly. All other special files are refused.
class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Protects a file from being replaced by an output. Hard links and symbolic links to it are recognised.
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
