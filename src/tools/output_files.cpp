// SPDX-License-Identifier: BSD-3-Clause
#include "output_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <random>
#include <set>
#include <stdexcept>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kMode = 0666;  // less the process's umask

[[noreturn]] void failToWrite(const fs::path& file, int error) {
  throw BadInput(file.string() + ": cannot be written, " + std::strerror(error));
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

fs::path uniqueNameBeside(const fs::path& file) {
  std::random_device random;
  return folderOf(file) / (".lps-" + std::to_string(random()) + std::to_string(random()) + ".part");
}

fs::path nameOfDescriptor(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

// Unnamed files can only be named later if /proc is mounted.
int openUnnamed(const fs::path& file) {
  const int descriptor = ::open(folderOf(file).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
  if (descriptor < 0 || access(nameOfDescriptor(descriptor).c_str(), W_OK) == 0) return descriptor;
  close(descriptor);
  errno = EOPNOTSUPP;
  return -1;
}

bool lacksUnnamedFiles(int error) { return error == EOPNOTSUPP || error == EISDIR || error == EINVAL; }

// O_EXCL: two calls never get the same file, and a symbolic link of this name is not followed.
int openUnique(const fs::path& file, fs::path& name) {
  for (;;) {
    name = uniqueNameBeside(file);
    const int descriptor = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kMode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

void writeAll(int descriptor, const void* bytes, std::size_t size, const fs::path& file) {
  const char* next = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t written = ::write(descriptor, next, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) failToWrite(file, errno);
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

// Gives an unnamed file a unique name, since linkat() cannot replace an existing file but rename() can.
fs::path nameUnnamed(int descriptor, const fs::path& target, const fs::path& file) {
  for (;;) {
    fs::path name = uniqueNameBeside(target);
    if (linkat(AT_FDCWD, nameOfDescriptor(descriptor).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) ==
        0) {
      return name;
    }
    if (errno != EEXIST) failToWrite(file, errno);
  }
}

// A renamed file is only safe from a power failure once its folder is written, too.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

void checkName(const fs::path& file) {
  const long limit = pathconf(folderOf(file).c_str(), _PC_NAME_MAX);
  if (limit > 0 && file.filename().string().size() > static_cast<std::size_t>(limit)) {
    failToWrite(file, ENAMETOOLONG);
  }
}

// Descriptor of a file that is open already, such as a standard output that is redirected to a file;
// otherwise -1.
int openDescriptorOf(const fs::path& file) {
  const std::string name = file.string();
  if (name == "/dev/stdout") return STDOUT_FILENO;
  if (name == "/dev/stderr") return STDERR_FILENO;
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (name.rfind(folder, 0) == 0) return std::atoi(name.c_str() + folder.size());
  }
  return -1;
}

// A copy of the descriptor has the same position: what the program prints to it later does not overwrite
// this.
int openDevice(const fs::path& file) {
  const int open_descriptor = openDescriptorOf(file);
  if (open_descriptor >= 0) return fcntl(open_descriptor, F_DUPFD_CLOEXEC, 0);
  return ::open(file.c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC);
}

fs::path targetOf(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(file, error)) return file;
  const fs::path target = fs::canonical(file, error);
  if (error) throw BadInput(file.string() + ": is a symbolic link to a file that does not exist");
  return target;
}

}  // namespace

void makeOutputFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error)) throw BadInput(folder.string() + ": cannot make this folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw BadInput(folder.string() + ": may not write to this folder");
}

fs::path wholePath(const fs::path& path) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(path), error);
  // Fails for links that lead to no file, as those of /dev/stdout to a pipe.
  return error ? fs::absolute(path).lexically_normal() : whole;
}

bool isStream(const fs::path& file) {
  std::error_code error;
  return openDescriptorOf(file) >= 0 || fs::is_fifo(fs::status(file, error));
}

OutputFiles::~OutputFiles() {
  for (const Pending& pending : pending_) {
    if (pending.descriptor >= 0) close(pending.descriptor);
    if (!pending.temporary.empty()) unlink(pending.temporary.c_str());
  }
}

void OutputFiles::protect(const fs::path& input) { protected_.push_back(input); }

void OutputFiles::checkProtected(const fs::path& file) const {
  for (const fs::path& input : protected_) {
    std::error_code error;
    if (fs::equivalent(file, input, error) && !error) {
      throw BadInput(file.string() + ": would overwrite the input " + input.string());
    }
  }
}

OutputFiles::Pending& OutputFiles::open(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) throw BadInput(file.string() + ": is a folder");
  Pending pending;
  pending.file = file;
  pending.is_device = fs::is_character_file(status) || isStream(file);
  pending.target = pending.is_device ? file : targetOf(file);
  if (fs::exists(status) && !pending.is_device && !fs::is_regular_file(status)) {
    throw BadInput(file.string() + ": is neither a file nor a character device");
  }
  checkName(pending.target);
  checkProtected(file);
  for (const Pending& other : pending_) {
    if (!pending.is_device && !other.is_device && wholePath(other.target) == wholePath(pending.target)) {
      throw BadInput(file.string() + ": two outputs have this name");
    }
  }
  if (pending.is_device) {
    pending.descriptor = openDevice(file);
  } else {
    pending.descriptor = openUnnamed(pending.target);
    if (pending.descriptor < 0 && lacksUnnamedFiles(errno)) {
      pending.descriptor = openUnique(pending.target, pending.temporary);
    }
  }
  if (pending.descriptor < 0) failToWrite(file, errno);
  pending_.push_back(pending);
  return pending_.back();
}

fs::path OutputFiles::reserve(const fs::path& file) {
  const Pending& pending = open(file);
  if (pending.is_device) return file;
  return pending.temporary.empty() ? nameOfDescriptor(pending.descriptor) : pending.temporary;
}

void OutputFiles::add(const fs::path& file, const void* bytes, std::size_t size) {
  writeAll(open(file).descriptor, bytes, size, file);
}

void OutputFiles::add(const fs::path& file, const std::string& text) { add(file, text.data(), text.size()); }

void OutputFiles::add(const fs::path& file, const std::vector<unsigned char>& bytes) {
  add(file, bytes.data(), bytes.size());
}

void OutputFiles::append(const fs::path& file, const std::string& text) {
  const auto found = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& pending) { return pending.file == file; });
  if (found == pending_.end()) throw std::logic_error(file.string() + ": was not added");
  writeAll(found->descriptor, text.data(), text.size(), file);
}

void OutputFiles::commit() {
  std::set<fs::path> folders;
  for (const Pending& pending : pending_) {
    if (!pending.is_device && fsync(pending.descriptor) != 0) failToWrite(pending.file, errno);
  }
  for (Pending& pending : pending_) {
    if (pending.is_device) continue;
    if (pending.temporary.empty()) {
      pending.temporary = nameUnnamed(pending.descriptor, pending.target, pending.file);
    }
    folders.insert(folderOf(pending.target));
  }
  for (Pending& pending : pending_) {
    if (pending.is_device) continue;
    if (rename(pending.temporary.c_str(), pending.target.c_str()) != 0) failToWrite(pending.file, errno);
    pending.temporary.clear();
  }
  for (const fs::path& folder : folders) syncFolder(folder);
  for (const Pending& pending : pending_) close(pending.descriptor);
  pending_.clear();
}

}  // namespace line_plane_segmentation
