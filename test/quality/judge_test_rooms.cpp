// SPDX-License-Identifier: BSD-3-Clause
// Segments the set of simulated rooms and writes what evaluate_segmentation and people need to judge it.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "evaluation.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "output_files.h"
#include "overlay.h"
#include "run_tool.h"
#include "simulated_rooms.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

using Labels = std::vector<std::uint16_t>;

constexpr double kTolerance = 0.8;

// Truth regions that count and were not found as one region.
std::vector<std::uint16_t> regionsNotFound(const RegionOverlaps& regions) {
  std::vector<std::uint16_t> not_found;
  for (std::size_t t = 0; t < regions.truth.size(); ++t) {
    const CountedRegion& truth = regions.truth[t];
    if (truth.pixels < kSimulatedMinPixels) continue;
    const bool found = std::any_of(regions.overlaps.begin(), regions.overlaps.end(), [&](const Overlap& o) {
      const auto enough = static_cast<double>(o.pixels) / kTolerance;
      return o.truth == t && enough >= static_cast<double>(truth.pixels) &&
             enough >= static_cast<double>(regions.labels[o.label].pixels);
    });
    if (!found) not_found.push_back(truth.value);
  }
  return not_found;
}

// The label image in the colours of the truth: what covers a true plane best takes its number, all else new
// ones.
Labels inColorsOfTruth(const Labels& labels, const RegionOverlaps& regions) {
  std::vector<Overlap> largest_first = regions.overlaps;
  std::stable_sort(largest_first.begin(), largest_first.end(),
                   [](const Overlap& a, const Overlap& b) { return a.pixels > b.pixels; });
  std::map<std::uint16_t, std::uint16_t> number_of_label{{std::uint16_t{0}, std::uint16_t{0}}};
  std::vector<bool> taken(regions.truth.size(), false);
  for (const Overlap& overlap : largest_first) {
    if (taken[overlap.truth]) continue;
    const std::uint16_t number = regions.truth[overlap.truth].value;
    taken[overlap.truth] = number_of_label.emplace(regions.labels[overlap.label].value, number).second;
  }
  std::uint16_t next = regions.truth.empty() ? 1 : regions.truth.back().value;
  Labels numbers(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto [entry, is_new] = number_of_label.emplace(labels[i], static_cast<std::uint16_t>(next + 1));
    if (is_new) ++next;
    numbers[i] = entry->second;
  }
  return numbers;
}

cv::Mat imageOf(const SimulatedFrame& frame, const std::vector<std::uint16_t>& pixels) {
  return cv::Mat(frame.height(), frame.width(), CV_16UC1, const_cast<std::uint16_t*>(pixels.data()));
}

cv::Mat tinted(const SimulatedFrame& frame, const Labels& labels) {
  Segmentation segmentation;
  segmentation.width = frame.width();
  segmentation.height = frame.height();
  segmentation.labels = labels;
  for (std::uint16_t& label : segmentation.labels) label = label == kDoNotJudge ? std::uint16_t{0} : label;
  return drawOverlay(viewOf(frame.depth.data(), frame.width(), frame.height()), segmentation, frame.camera);
}

// The truth at the left, at the right what was found; framed in the truth what was not found as one region.
cv::Mat pictureOf(const SimulatedFrame& frame, const Labels& labels, const RegionOverlaps& regions) {
  cv::Mat truth = tinted(frame, frame.truth);
  for (const std::uint16_t missing : regionsNotFound(regions)) {
    std::vector<std::vector<cv::Point>> contours;
    cv::Mat mask = imageOf(frame, frame.truth) == missing;
    cv::morphologyEx(mask, mask, cv::MORPH_CLOSE, cv::Mat::ones(7, 7, CV_8UC1));
    cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::drawContours(truth, contours, -1, cv::Scalar::all(255), 4);
  }
  cv::Mat pair;
  cv::hconcat(truth, tinted(frame, inColorsOfTruth(labels, regions)), pair);
  cv::resize(pair, pair, {}, 0.5, 0.5, cv::INTER_AREA);
  return pair;
}

void addPng(const fs::path& file, const cv::Mat& image, OutputFiles& files) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 9});
  files.add(file, bytes);
}

std::string tableRow(const SimulatedFrame& frame) {
  std::ostringstream row;
  row << frame.name << "," << frame.width() << "," << frame.height() << ",0.001," << frame.camera.fx << ","
      << frame.camera.fy << "," << frame.camera.cx << "," << frame.camera.cy << "\n";
  return row.str();
}

// Writes the rooms as a labelled set for evaluate_segmentation --robust.
void writeSet(const fs::path& folder, const RoomRange& rooms) {
  for (const char* images : {"truth", "depth"}) makeOutputFolder(folder / images);
  std::string table = "frame,width,height,depth_unit,fx,fy,cx,cy\n";
  OutputFiles files;
  forEachSimulatedFrame(rooms, [&](const SimulatedFrame& frame) {
    addPng(folder / "truth" / (frame.name + ".png"), imageOf(frame, frame.truth), files);
    addPng(folder / "depth" / (frame.name + ".png"), imageOf(frame, frame.depth), files);
    table += tableRow(frame);
  });
  files.add(folder / "frames.csv", table);
  files.commit();
}

void judge(const fs::path& out, const std::string& preset) {
  Parameters parameters;
  if (!loadPreset(preset, parameters)) throw BadInput("no preset is named '" + preset + "'");
  for (const char* folder : {"truth", "labels", "pictures"}) makeOutputFolder(out / folder);

  PlaneSegmenter segmenter(parameters);
  forEachSimulatedFrame(kSeenRooms, [&](const SimulatedFrame& frame) {
    const Labels& labels =
        segmenter.segment(viewOf(frame.depth.data(), frame.width(), frame.height()), frame.camera).labels;
    const RegionOverlaps regions = countOverlaps(frame.truth.data(), labels.data(), labels.size());
    const std::string file = frame.name + ".png";
    OutputFiles files;
    addPng(out / "truth" / file, imageOf(frame, frame.truth), files);
    addPng(out / "labels" / file, imageOf(frame, labels), files);
    addPng(out / "pictures" / file, pictureOf(frame, labels, regions), files);
    files.commit();
  });
  writeSet(out / "simulated", kSeenRooms);
  writeSet(out / "simulated_deciding", kDecidingRooms);
  writeSet(out / "simulated_confirming", kConfirmingRooms);
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  using namespace line_plane_segmentation;
  if (argc < 2 || argc > 3 || argv[1][0] == '-') {
    std::cerr
        << "Usage: judge_test_rooms DIR [PRESET]\n"
           "Writes truth, labels and pictures (left: the truth, right: what was found) of each frame,\n"
           "and the labelled sets DIR/simulated, DIR/simulated_deciding and DIR/simulated_confirming.\n";
    return 1;
  }
  return runTool("judge_test_rooms", [=] { judge(argv[1], argc == 3 ? argv[2] : "kinect"); });
}
