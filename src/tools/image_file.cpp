// SPDX-License-Identifier: BSD-3-Clause
#include "image_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "image_header.h"
#include "npy_file.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;

// OpenCV and libpng write their messages about a damaged file to stderr, without the file's name. During the
// lifetime of this object stderr is /dev/null.
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

cv::Mat decodeSilently(const Bytes& bytes) {
  // OpenCV reads EXR since 4.5 only if this is set.
  setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 0);
  const SilentStderr silence;
  try {
    return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

[[noreturn]] void refuseDamaged(const fs::path& file) {
  throw BadInput(file.string() + ": cannot be read as an image, broken or empty?");
}

void checkSize(const ImageHeader& header, const fs::path& file, std::int64_t max_pixels) {
  if (header.width < 1 || header.height < 1) refuseDamaged(file);
  if (header.width > max_pixels / header.height) {
    throw BadInput(file.string() + ": has " + std::to_string(header.width) + " x " +
                   std::to_string(header.height) + " pixels, too many; see --max-pixels");
  }
}

void checkChannels(int channels, const fs::path& file) {
  if (channels != 1) {
    throw BadInput(file.string() + ": has " + std::to_string(channels) + " channels, not one of 16 bits");
  }
}

void checkBits(int bits, const fs::path& file) {
  if (bits != 16) throw BadInput(file.string() + ": has " + std::to_string(bits) + " bits a pixel, not 16");
}

// An EXR with the single channel Z comes with three equal channels from OpenCV.
cv::Mat singleChannel(const cv::Mat& image, const fs::path& file) {
  if (image.depth() != CV_32F || image.channels() != 3) {
    checkChannels(image.channels(), file);
    return image;
  }
  cv::Mat channels[3];
  cv::split(image, channels);
  const auto differ = [&](int other) { return cv::norm(channels[0], channels[other], cv::NORM_INF) != 0.0; };
  if (differ(1) || differ(2)) checkChannels(3, file);
  return channels[0];
}

void checkPng(const fs::path& file, const Bytes& start, std::ifstream& stream, std::int64_t max_pixels) {
  const std::optional<ImageHeader> header = readImageHeader(start);
  if (!header) refuseDamaged(file);
  checkSize(*header, file, max_pixels);
  checkChannels(header->channels, file);
  checkBits(header->bits, file);
  char end[12] = {};  // the last chunk: length, "IEND", checksum
  stream.clear();
  stream.seekg(-static_cast<std::streamoff>(sizeof end), std::ios::end);
  if (!stream.read(end, sizeof end) || std::memcmp(end + 4, "IEND", 4) != 0) refuseDamaged(file);
}

std::ifstream openFile(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw BadInput(file.string() + ": no such file");
  if (!fs::is_regular_file(file, error)) throw BadInput(file.string() + ": is not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw BadInput(file.string() + ": cannot be read");
  return stream;
}

}  // namespace

Bytes readFile(const fs::path& file) {
  std::ifstream stream = openFile(file);
  stream.seekg(0, std::ios::end);
  Bytes bytes(static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0)));
  stream.seekg(0);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()))) {
    throw BadInput(file.string() + ": cannot be read");
  }
  return bytes;
}

void checkDepthFile(const fs::path& file, std::int64_t max_pixels) {
  std::ifstream stream = openFile(file);
  constexpr std::size_t kStart = 64;
  Bytes start(kStart);
  stream.read(reinterpret_cast<char*>(start.data()), kStart);
  start.resize(static_cast<std::size_t>(stream.gcount()));
  if (isPng(start)) return checkPng(file, start, stream, max_pixels);
  decodeDepth(readFile(file), file, max_pixels);
}

cv::Mat decodeDepth(const Bytes& bytes, const fs::path& file, std::int64_t max_pixels) {
  cv::Mat image;
  if (isNpy(bytes)) {
    image = decodeNpy(bytes, file.string(), max_pixels);
  } else {
    const std::optional<ImageHeader> header = readImageHeader(bytes);
    if (header) checkSize(*header, file, max_pixels);
    image = decodeSilently(bytes);
    if (image.empty()) refuseDamaged(file);
    image = singleChannel(image, file);
  }
  if (image.depth() == CV_64F) image.convertTo(image, CV_32F);
  if (image.depth() != CV_32F && image.depth() != CV_16U)
    checkBits(static_cast<int>(8 * image.elemSize()), file);
  return image;
}

cv::Mat readImage16(const fs::path& file, std::int64_t max_pixels) {
  cv::Mat image = decodeDepth(readFile(file), file, max_pixels);
  if (image.depth() != CV_16U) checkBits(static_cast<int>(8 * image.elemSize()), file);
  return image;
}

}  // namespace line_plane_segmentation
