// SPDX-License-Identifier: BSD-3-Clause
#include "html_report.h"

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "frame_results.h"
#include "line_plane_segmentation/ros/palette.h"
#include "report_frame.h"
#include "report_plot.h"
#include "report_style.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPictures = 200;

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  using Iterator = boost::archive::iterators::base64_from_binary<
      boost::archive::iterators::transform_width<std::vector<unsigned char>::const_iterator, 6, 8>>;
  std::string text(Iterator(bytes.begin()), Iterator(bytes.end()));
  return text.append((3 - bytes.size() % 3) % 3, '=');
}

std::string fixed(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// "min_range = 0.5", of each parameter that is not at its default.
std::string changedParameters(const Parameters& parameters) {
  const nlohmann::json now = settingsOf({}, parameters).at("parameters");
  const nlohmann::json defaults = settingsOf({}, {}).at("parameters");
  std::string text;
  for (const auto& [name, value] : now.items()) {
    if (value != defaults.at(name)) text += (text.empty() ? "" : ", ") + name + " = " + value.dump();
  }
  return text.empty() ? "the defaults" : text;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string tile(const std::string& value, const std::string& what) {
  return "<div class=\"tile\"><b>" + value + "</b>" + what + "</div>";
}

std::string legend() {
  std::string html = "<p class=\"legend\">";
  for (int s = 0; s < kStageCount; ++s) {
    html += std::string("<span><i style=\"background:") + kStageColors[static_cast<std::size_t>(s)] +
            "\"></i>" + nameOf(static_cast<Stage>(s)) + "</span>";
  }
  return html + "</p>\n";
}

std::string summary(const std::vector<ReportFrame>& frames, const Parameters& parameters) {
  std::vector<double> times;
  double planes = 0.0;
  for (const ReportFrame& frame : frames) {
    times.push_back(frame.milliseconds);
    planes += static_cast<double>(frame.planes.size());
  }
  return "<h1>Planes in depth images</h1>\n<p>Parameters: " + escaped(changedParameters(parameters)) +
         ".</p>\n" + "<div class=\"tiles\">" + tile(std::to_string(frames.size()), "frames") +
         tile(fixed(planes / static_cast<double>(frames.size()), 1), "planes a frame") +
         tile(fixed(median(times), 2) + " ms", "a frame (median)") +
         tile(fixed(*std::max_element(times.begin(), times.end()), 2) + " ms", "the slowest") + "</div>\n" +
         summaryPlot(frames) + legend();
}

std::string planeTable(const std::vector<ReportPlane>& planes) {
  if (planes.empty()) return "<p>No planes.</p>\n";
  std::string html =
      "<table><tr><th>plane</th><th>normal</th><th>distance [m]</th><th>area [m²]</th><th>rms [mm]</th>"
      "<th>pixels</th></tr>\n";
  for (const ReportPlane& plane : planes) {
    const Color color = colorOf(plane.label);
    html += "<tr><td><i style=\"background:rgb(" + std::to_string(color.r) + "," + std::to_string(color.g) +
            "," + std::to_string(color.b) + ")\"></i>" + std::to_string(plane.label) + "</td><td>" +
            fixed(plane.normal[0], 3) + " " + fixed(plane.normal[1], 3) + " " + fixed(plane.normal[2], 3) +
            "</td><td>" + fixed(plane.d, 3) + "</td><td>" + fixed(plane.area, 3) + "</td><td>" +
            fixed(1000.0 * plane.rms, 1) + "</td><td>" + std::to_string(plane.inliers) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

std::string timeTable(const ReportFrame& frame) {
  std::string head = "<table><tr>", row = "<tr>";
  for (int s = 0; s < kStageCount; ++s) {
    head += std::string("<th>") + nameOf(static_cast<Stage>(s)) + "</th>";
    row += "<td>" + fixed(frame.stage_milliseconds[static_cast<std::size_t>(s)], 2) + "</td>";
  }
  return head + "<th>total [ms]</th></tr>\n" + row + "<td>" + fixed(frame.milliseconds, 2) +
         "</td></tr></table>\n";
}

std::string picture(const fs::path& overlay) {
  const cv::Mat image = cv::imread(overlay.string(), cv::IMREAD_COLOR);
  if (image.empty()) throw BadInput(overlay.string() + ": cannot be read for the report");
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 85});
  return "<img alt=\"planes over the depth image\" width=\"" + std::to_string(image.cols) + "\" height=\"" +
         std::to_string(image.rows) + "\" src=\"data:image/jpeg;base64," + base64(jpeg) + "\">\n";
}

}  // namespace

void writeHtmlReport(const fs::path& file, const DepthTask& task) {
  std::vector<ReportFrame> frames;
  double slowest = 0.0;
  for (const DepthFrame& frame : task.frames) {
    frames.push_back(readReportFrame(FrameResults(task.out, frame).planes));
    slowest = std::max(slowest, frames.back().milliseconds);
  }
  std::ofstream page(file);
  page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
          "<title>Planes in depth images</title>\n<style>"
       << kReportStyle << "</style>\n</head>\n<body>\n"
       << summary(frames, task.parameters);
  const std::size_t pictures = std::min(frames.size(), kMostPictures);
  if (pictures < frames.size()) {
    page << "<p>Pictures of " << pictures << " of the " << frames.size() << " frames are shown.</p>\n";
  }
  std::size_t shown = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    page << "<article id=\"frame-" << i << "\">\n<h2>" << escaped(frames[i].name) << "</h2>\n";
    if (i == shown * frames.size() / pictures) {
      page << picture(FrameResults(task.out, task.frames[i]).overlay);
      ++shown;
    }
    page << "<div>\n"
         << planeTable(frames[i].planes) << timeTable(frames[i]) << stageBar(frames[i], slowest)
         << "\n</div>\n</article>\n";
  }
  page << "</body>\n</html>\n";
  page.close();
  if (!page) throw BadInput(task.report.string() + ": cannot be written");
}

}  // namespace line_plane_segmentation
