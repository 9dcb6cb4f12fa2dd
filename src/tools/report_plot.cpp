// SPDX-License-Identifier: BSD-3-Clause
#include "report_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace line_plane_segmentation {

const std::array<const char*, kStageCount> kStageColors = {"#4477aa", "#66ccee", "#228833", "#ccbb44",
                                                           "#ee6677"};

namespace {

constexpr double kWidth = 1000.0;
constexpr double kLeft = 46.0;
constexpr double kPlotWidth = kWidth - kLeft - 6.0;
constexpr double kTimesTop = 22.0;
constexpr double kTimesHeight = 150.0;
constexpr double kPlanesTop = 218.0;
constexpr double kPlanesHeight = 90.0;
constexpr double kHeight = 330.0;
constexpr std::size_t kMostColumns = 300;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[400];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// The means of neighbouring frames.
struct Column {
  std::size_t first = 0;
  std::array<double, kStageCount> stages{};
  double milliseconds = 0.0;
  double planes = 0.0;
};

std::vector<Column> columnsOf(const std::vector<ReportFrame>& frames) {
  std::vector<Column> columns(std::min(frames.size(), kMostColumns));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Column& column = columns[c];
    column.first = c * frames.size() / columns.size();
    const std::size_t end = (c + 1) * frames.size() / columns.size();
    const double share = 1.0 / static_cast<double>(end - column.first);
    for (std::size_t i = column.first; i < end; ++i) {
      for (std::size_t s = 0; s < column.stages.size(); ++s) {
        column.stages[s] += share * frames[i].stage_milliseconds[s];
        column.milliseconds += share * frames[i].stage_milliseconds[s];
      }
      column.planes += share * static_cast<double>(frames[i].planes.size());
    }
  }
  return columns;
}

// The least of 1, 2, 5, 10, 20, ... that is not below.
double roundUp(double value) {
  if (value <= 0.0) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= value) return step * power;
  }
  return 10.0 * power;
}

std::string axes(double top, double height, double largest, const char* title) {
  std::string svg = format("<text class=\"title\" x=\"0\" y=\"%.1f\">%s</text>", top - 8.0, title);
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = top + height * (1.0 - share);
    svg += format("<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", kLeft,
                  kLeft + kPlotWidth, y, y);
    svg +=
        format("<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">%g</text>", kLeft - 6.0, y + 4.0, share * largest);
  }
  return svg;
}

std::string bar(double x, double y, double width, double height, const char* color) {
  return format("<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"%s\"/>", x, y, width,
                height, color);
}

double largestOf(const std::vector<Column>& columns, double Column::*value) {
  double largest = 0.0;
  for (const Column& column : columns) largest = std::max(largest, column.*value);
  return roundUp(largest);
}

}  // namespace

std::string summaryPlot(const std::vector<ReportFrame>& frames) {
  const std::vector<Column> columns = columnsOf(frames);
  const double most_time = largestOf(columns, &Column::milliseconds);
  const double most_planes = largestOf(columns, &Column::planes);
  const double pitch = kPlotWidth / static_cast<double>(columns.size());
  const double width = std::min(0.85 * pitch, 40.0);

  std::string svg = format(
      "<svg class=\"plot\" viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-label=\"Times and planes of the "
      "frames\">",
      kWidth, kHeight);
  svg += axes(kTimesTop, kTimesHeight, most_time, "time of a frame [ms]");
  svg += axes(kPlanesTop, kPlanesHeight, most_planes, "planes of a frame");
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const Column& column = columns[c];
    const double x = kLeft + (static_cast<double>(c) + 0.5) * pitch - 0.5 * width;
    svg += "<a href=\"#frame-" + std::to_string(column.first) + "\">";
    svg += format("<title>%.2f ms, %g planes</title>", column.milliseconds, column.planes);
    double y = kTimesTop + kTimesHeight;
    for (std::size_t s = 0; s < column.stages.size(); ++s) {
      const double height = column.stages[s] / most_time * kTimesHeight;
      y -= height;
      svg += bar(x, y, width, height, kStageColors[s]);
    }
    const double planes = column.planes / most_planes * kPlanesHeight;
    svg += bar(x, kPlanesTop + kPlanesHeight - planes, width, planes, "#888") + "</a>";
  }
  svg += format("<text class=\"first\" x=\"%.1f\" y=\"%.1f\">first frame</text>", kLeft, kHeight - 4.0);
  svg += format("<text class=\"tick\" x=\"%.1f\" y=\"%.1f\">last of %zu</text>", kLeft + kPlotWidth,
                kHeight - 4.0, frames.size());
  return svg + "</svg>\n";
}

std::string stageBar(const ReportFrame& frame, double full) {
  std::string svg = "<svg class=\"bar\" viewBox=\"0 0 400 8\" preserveAspectRatio=\"none\">";
  double x = 0.0;
  for (std::size_t s = 0; s < frame.stage_milliseconds.size(); ++s) {
    const double width = 400.0 * frame.stage_milliseconds[s] / std::max(full, 1e-9);
    svg += bar(x, 0.0, width, 8.0, kStageColors[s]);
    x += width;
  }
  return svg + "</svg>";
}

}  // namespace line_plane_segmentation
