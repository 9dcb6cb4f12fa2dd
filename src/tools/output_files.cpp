// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <unistd.h>

#include <fstream>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

std::filesystem::path temporaryName(const std::filesystem::path& file) {
  return file.parent_path() / ("." + file.filename().string() + ".part");
}

}  // namespace

void makeOutputFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error)) {
    throw BadInput(folder.string() + ": cannot make this folder");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw BadInput(folder.string() + ": may not write to this folder");
}

std::filesystem::path wholePath(const std::filesystem::path& path) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
}

OutputFiles::~OutputFiles() {
  std::error_code ignored;
  for (const auto& file : pending_) std::filesystem::remove(temporaryName(file), ignored);
}

std::filesystem::path OutputFiles::reserve(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw BadInput(file.string() + ": is a folder");
  pending_.push_back(file);
  if (!std::ofstream(temporaryName(file))) throw BadInput(file.string() + ": cannot be written");
  return temporaryName(file);
}

void OutputFiles::add(const std::filesystem::path& file, const void* bytes, std::size_t size) {
  pending_.push_back(file);
  std::ofstream stream(temporaryName(file), std::ios::binary);
  stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  stream.close();
  if (!stream) throw BadInput(file.string() + ": cannot be written");
}

void OutputFiles::add(const std::filesystem::path& file, const std::string& text) {
  add(file, text.data(), text.size());
}

void OutputFiles::add(const std::filesystem::path& file, const std::vector<unsigned char>& bytes) {
  add(file, bytes.data(), bytes.size());
}

void OutputFiles::commit() {
  std::error_code error;
  for (const auto& file : pending_) {
    std::filesystem::rename(temporaryName(file), file, error);
    if (error) throw BadInput(file.string() + ": cannot be written, " + error.message());
  }
  pending_.clear();
}

}  // namespace line_plane_segmentation
