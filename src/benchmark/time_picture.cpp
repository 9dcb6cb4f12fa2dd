// SPDX-License-Identifier: BSD-3-Clause
#include "time_picture.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "table.h"

namespace line_plane_segmentation {
namespace {

const cv::Scalar kInk(60, 60, 60);
const cv::Scalar kGrid(225, 225, 225);
const cv::Scalar kOurs(80, 140, 40);
const cv::Scalar kPeers(190, 110, 30);
constexpr int kLeft = 150;
constexpr int kRight = 90;
constexpr int kWidth = 960;
constexpr int kRow = 22;
constexpr int kPanelHead = 40;
constexpr int kAxisFoot = 50;
constexpr int kFirstDecade = -1;  // 0.1 ms
constexpr int kLastDecade = 4;    // 10 s

void write(cv::Mat& picture, const std::string& text, cv::Point at, double size = 0.45) {
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, kInk, 1, cv::LINE_AA);
}

int columnOf(double milliseconds) {
  const double share =
      (std::log10(std::max(milliseconds, 1e-9)) - kFirstDecade) / (kLastDecade - kFirstDecade);
  return kLeft + cvRound(std::min(std::max(share, 0.0), 1.0) * (kWidth - kLeft - kRight));
}

void drawGrid(cv::Mat& picture) {
  for (int decade = kFirstDecade; decade <= kLastDecade; ++decade) {
    const int column = columnOf(std::pow(10.0, decade));
    cv::line(picture, {column, kPanelHead / 2}, {column, picture.rows - kAxisFoot + 5}, kGrid);
    const std::string text = decade < 0 ? "0.1 ms" : "1" + std::string(static_cast<std::size_t>(decade), '0');
    write(picture, text, {column - 8, picture.rows - kAxisFoot + 25});
  }
}

void drawBar(cv::Mat& picture, const Measurement& m, int row) {
  const cv::Scalar& color = m.stages.empty() ? kPeers : kOurs;
  write(picture, m.method, {20, row + 5});
  cv::line(picture, {columnOf(m.total.min), row}, {columnOf(m.total.max), row}, color, 3, cv::LINE_AA);
  cv::circle(picture, {columnOf(m.total.median), row}, 5, color, cv::FILLED, cv::LINE_AA);
  write(picture, threeDigits(m.total.median), {columnOf(m.total.max) + 12, row + 5}, 0.4);
}

}  // namespace

cv::Mat drawTimes(const std::vector<Measurement>& measurements) {
  std::vector<Measurement> shown;
  int panels = 0;
  for (const Measurement& m : measurements) {
    if (m.width != measurements.front().width || m.height != measurements.front().height) continue;
    if (shown.empty() || shown.back().frame != m.frame) ++panels;
    shown.push_back(m);
  }
  cv::Mat picture(panels * kPanelHead + static_cast<int>(shown.size()) * kRow + kAxisFoot, kWidth, CV_8UC3,
                  cv::Scalar::all(255));
  drawGrid(picture);
  int row = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (i == 0 || shown[i - 1].frame != shown[i].frame) {
      row += kPanelHead;
      write(picture, shown[i].frame, {20, row - 12}, 0.55);
    }
    drawBar(picture, shown[i], row + kRow / 2);
    row += kRow;
  }
  return picture;
}

}  // namespace line_plane_segmentation
