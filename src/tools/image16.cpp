// SPDX-License-Identifier: BSD-3-Clause
#include "image16.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

// OpenCV and libpng report a broken file straight to stderr, each in its own words and without the
// file's name. While this lives they write to nowhere.
class SilentStderr {
 public:
  SilentStderr() : saved_(dup(STDERR_FILENO)) {
    std::fflush(stderr);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0) return;
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
  ~SilentStderr() {
    std::fflush(stderr);
    if (saved_ < 0) return;
    dup2(saved_, STDERR_FILENO);
    close(saved_);
  }
  SilentStderr(const SilentStderr&) = delete;
  SilentStderr& operator=(const SilentStderr&) = delete;

 private:
  int saved_;
};

cv::Mat readSilently(const std::string& file) {
  const SilentStderr silence;
  try {
    return cv::imread(file, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace

cv::Mat readImage16(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw BadInput(name + ": no such file");
  if (!std::filesystem::is_regular_file(file, error)) throw BadInput(name + ": is not a file");

  cv::Mat image = readSilently(name);
  if (image.empty()) throw BadInput(name + ": cannot be read as an image, broken or empty?");
  if (image.channels() != 1) {
    throw BadInput(name + ": has " + std::to_string(image.channels()) + " channels, not one of 16 bits");
  }
  if (image.depth() != CV_16U) {
    throw BadInput(name + ": has " + std::to_string(8 * image.elemSize()) + " bits a pixel, not 16");
  }
  return image;
}

}  // namespace line_plane_segmentation
