// SPDX-License-Identifier: BSD-3-Clause
#include "curve_picture.h"

#include <array>
#include <boost/format.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

namespace line_plane_segmentation {
namespace {

const cv::Scalar kInk(60, 60, 60);
const cv::Scalar kGrid(225, 225, 225);
const cv::Rect kPlot(90, 60, 600, 420);
const cv::Size kPicture(960, 560);

struct Series {
  std::string name;
  cv::Scalar color;
  double (*share)(const HooverCounts&);
};

double ratio(int part, int whole) { return whole == 0 ? 0.0 : static_cast<double>(part) / whole; }

std::array<Series, 5> allSeries() {
  return {
      {{"correct", {80, 140, 40}, [](const HooverCounts& c) { return ratio(c.correct, c.required); }},
       {"over-segmented",
        {190, 110, 30},
        [](const HooverCounts& c) { return ratio(c.over_segmented, c.required); }},
       {"under-segmented", {160, 70, 140}, [](const HooverCounts& c) { return ratio(c.merged, c.required); }},
       {"missed", {50, 50, 210}, [](const HooverCounts& c) { return ratio(c.missed, c.required); }},
       {"noise", {30, 150, 230}, [](const HooverCounts& c) { return ratio(c.noise, c.labels); }}}};
}

void write(cv::Mat& picture, const std::string& text, cv::Point at, double size = 0.5,
           const cv::Scalar& color = kInk) {
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, color, 1, cv::LINE_AA);
}

void writeCentred(cv::Mat& picture, const std::string& text, cv::Point at, double size = 0.5) {
  const cv::Size extent = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, nullptr);
  write(picture, text, {at.x - extent.width / 2, at.y}, size);
}

int columnOf(double tolerance) { return kPlot.x + cvRound((tolerance - 0.5) / 0.5 * kPlot.width); }

int rowOf(double share) { return kPlot.y + cvRound((1.0 - share) * kPlot.height); }

void drawAxes(cv::Mat& picture) {
  for (int tenths = 0; tenths <= 10; tenths += 2) {
    const int row = rowOf(tenths / 10.0);
    cv::line(picture, {kPlot.x, row}, {kPlot.x + kPlot.width, row}, kGrid);
    write(picture, (boost::format("%.1f") % (tenths / 10.0)).str(), {kPlot.x - 38, row + 5});
  }
  for (int tenths = 5; tenths <= 10; ++tenths) {
    const int column = columnOf(tenths / 10.0);
    cv::line(picture, {column, kPlot.y}, {column, kPlot.y + kPlot.height}, kGrid);
    writeCentred(picture, (boost::format("%.1f") % (tenths / 10.0)).str(),
                 {column, kPlot.y + kPlot.height + 22});
  }
  cv::rectangle(picture, kPlot.tl(), kPlot.br(), kInk);
  writeCentred(picture, "tolerance", {kPlot.x + kPlot.width / 2, kPlot.y + kPlot.height + 50}, 0.55);
  write(picture, "share of the regions", {kPlot.x, kPlot.y - 20}, 0.55);
}

void drawSeries(cv::Mat& picture, const Series& series, const std::vector<CurvePoint>& curve) {
  std::vector<cv::Point> points;
  for (const CurvePoint& point : curve)
    points.emplace_back(columnOf(point.tolerance), rowOf(series.share(point.counts)));
  cv::polylines(picture, points, false, series.color, 2, cv::LINE_AA);
}

}  // namespace

cv::Mat drawCurve(const std::vector<CurvePoint>& curve, double marked_tolerance,
                  const HooverCounts& marked_counts) {
  cv::Mat picture(kPicture, CV_8UC3, cv::Scalar::all(255));
  drawAxes(picture);
  const int marked = columnOf(marked_tolerance);
  cv::line(picture, {marked, kPlot.y}, {marked, kPlot.y + kPlot.height}, cv::Scalar::all(150));

  cv::Point legend(kPlot.x + kPlot.width + 25, kPlot.y + 20);
  write(picture, (boost::format("at tolerance %.3g") % marked_tolerance).str(), legend);
  for (const Series& series : allSeries()) {
    drawSeries(picture, series, curve);
    legend.y += 34;
    cv::line(picture, legend - cv::Point(0, 5), legend + cv::Point(24, -5), series.color, 3, cv::LINE_AA);
    write(picture, series.name, legend + cv::Point(34, 0));
    write(picture, (boost::format("%.2f") % series.share(marked_counts)).str(), legend + cv::Point(185, 0));
  }
  write(picture, (boost::format("%d truth regions") % marked_counts.required).str(),
        legend + cv::Point(0, 50), 0.45);
  write(picture, (boost::format("%d label regions") % marked_counts.labels).str(), legend + cv::Point(0, 74),
        0.45);
  return picture;
}

}  // namespace line_plane_segmentation
