// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_pictures.h"

#include <opencv2/imgproc.hpp>

#include "overlay.h"

namespace line_plane_segmentation {
namespace {

constexpr int kCellWidth = 320;
constexpr int kCellHeight = 240;
constexpr int kGap = 8;
constexpr int kHead = 28;
constexpr int kLeft = 110;

cv::Mat draw(const BenchmarkFrame& frame, std::vector<std::uint16_t> labels) {
  cv::Mat depth(frame.height, frame.width, CV_16UC1);
  std::copy(frame.depth.begin(), frame.depth.end(), depth.begin<std::uint16_t>());
  Segmentation segmentation;
  segmentation.width = frame.width;
  segmentation.height = frame.height;
  segmentation.labels = std::move(labels);
  return drawOverlay(depth, segmentation, frame.camera);
}

void write(cv::Mat& sheet, const std::string& text, const cv::Point& at) {
  cv::putText(sheet, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.55, cv::Scalar::all(40), 1, cv::LINE_AA);
}

// As large as fits into the cell, in its middle.
void putInto(cv::Mat cell, const cv::Mat& picture) {
  const double scale =
      std::min(cell.cols / static_cast<double>(picture.cols), cell.rows / static_cast<double>(picture.rows));
  cv::Mat scaled;
  cv::resize(picture, scaled, {}, scale, scale, cv::INTER_AREA);
  scaled.copyTo(
      cell(cv::Rect((cell.cols - scaled.cols) / 2, (cell.rows - scaled.rows) / 2, scaled.cols, scaled.rows)));
}

}  // namespace

SegmentationPictures drawSegmentations(const std::vector<BenchmarkFrame>& frames,
                                       const std::vector<Contestant>& methods) {
  SegmentationPictures pictures;
  const auto columns = static_cast<int>(methods.size()), rows = static_cast<int>(frames.size());
  pictures.sheet = cv::Mat(kHead + rows * (kCellHeight + kGap), kLeft + columns * (kCellWidth + kGap),
                           CV_8UC3, cv::Scalar::all(255));
  for (int row = 0; row < rows; ++row) {
    const BenchmarkFrame& frame = frames[static_cast<std::size_t>(row)];
    const int top = kHead + row * (kCellHeight + kGap);
    write(pictures.sheet, frame.name, {8, top + kCellHeight / 2});
    for (int column = 0; column < columns; ++column) {
      const Contestant& method = methods[static_cast<std::size_t>(column)];
      const int left = kLeft + column * (kCellWidth + kGap);
      if (row == 0) write(pictures.sheet, method.name, {left, kHead - 9});
      method.engine->load(frame);
      const cv::Mat picture = draw(frame, method.engine->labels());
      putInto(pictures.sheet(cv::Rect(left, top, kCellWidth, kCellHeight)), picture);
      pictures.single.emplace_back(frame.name + "." + method.name, picture);
    }
  }
  return pictures;
}

}  // namespace line_plane_segmentation
