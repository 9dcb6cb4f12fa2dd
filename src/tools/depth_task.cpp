// SPDX-License-Identifier: BSD-3-Clause
#include "depth_task.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>

#include "frame_results.h"
#include "html_report.h"
#include "interruption.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/stage_clock.h"
#include "ordered_work.h"
#include "output_files.h"
#include "overlay.h"
#include "planes_json.h"
#include "progress.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<unsigned char>;

/// A frame that is being worked on, and what becomes of it.
struct Slot {
  const DepthFrame* frame = nullptr;
  cv::Mat depth;
  PlaneSegmenter segmenter;
  Bytes labels, overlay;
  std::string planes;
  std::string summary;
  bool out_of_range = false;  // most of its depths
};

Bytes encodePng(const cv::Mat& image) {
  Bytes bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

DepthView viewOf(const cv::Mat& depth, double units_per_metre) {
  DepthView view;
  view.data = depth.data;
  view.width = depth.cols;
  view.height = depth.rows;
  view.step = depth.step;
  view.type = DepthType::kUint16;
  view.metres_per_unit = static_cast<float>(1.0 / units_per_metre);
  return view;
}

// Whether most depths lie outside of min_range to max_range, as they do with a wrong depth scale.
bool isOutOfRange(const cv::Mat& depth, double units_per_metre, const ScanlineParameters& range) {
  const cv::Mat outside =
      (depth < range.min_range * units_per_metre) | (depth > range.max_range * units_per_metre);
  return 2 * cv::countNonZero(outside & (depth > 0)) > cv::countNonZero(depth);
}

std::string summaryOf(const DepthFrame& frame, const Segmentation& segmentation, const StageClock& clock) {
  const double share =
      segmentation.valid_pixels == 0 ? 0.0 : 100.0 * segmentation.assigned_pixels / segmentation.valid_pixels;
  char figures[96];
  std::snprintf(figures, sizeof figures, ": %zu planes, %.0f %% of the depth, %.2f ms",
                segmentation.planes.size(), share, clock.totalMilliseconds());
  return frame.name + figures;
}

void work(Slot& slot) {
  const DepthFrame& frame = *slot.frame;
  StageClock clock;
  Segmentation result =
      slot.segmenter.segment(viewOf(slot.depth, frame.units_per_metre), frame.camera, &clock);
  slot.labels = encodePng(cv::Mat(result.height, result.width, CV_16UC1, result.labels.data()));
  slot.overlay = encodePng(drawOverlay(slot.depth, result, frame.camera));
  slot.planes = planesJson(frame.name, result, clock, settingsOf(frame, slot.segmenter.parameters()));
  slot.summary = summaryOf(frame, result, clock);
  slot.out_of_range = isOutOfRange(slot.depth, frame.units_per_metre, slot.segmenter.parameters().scanlines);
}

// The frames that are still to be done.
std::vector<const DepthFrame*> unfinished(const DepthTask& task) {
  std::vector<const DepthFrame*> frames;
  for (const DepthFrame& frame : task.frames) {
    if (task.redo || !areFinished({task.out, frame}, frame, settingsOf(frame, task.parameters)))
      frames.push_back(&frame);
  }
  return frames;
}

void checkReport(const DepthTask& task, const std::set<fs::path>& results) {
  const fs::path file = wholePath(task.report);
  if (results.count(file) != 0)
    throw BadInput(task.report.string() + ": the report would overwrite a result");
  for (const DepthFrame& frame : task.frames) {
    if (wholePath(frame.image) == file)
      throw BadInput(task.report.string() + ": the report would overwrite an image");
  }
  if (fs::is_directory(file)) throw BadInput(task.report.string() + ": is a folder, no file for a report");
  if (!fs::is_directory(file.parent_path()) && file.parent_path() != wholePath(task.out)) {
    throw BadInput(task.report.string() + ": there is no folder for this report");
  }
}

// Everything that can be wrong with the input shows here, before anything is written.
void checkInput(const DepthTask& task, const std::vector<const DepthFrame*>& frames) {
  std::set<fs::path> results;
  for (const DepthFrame& frame : task.frames) {
    for (const fs::path& file : FrameResults(task.out, frame).all()) results.insert(wholePath(file));
  }
  if (!task.report.empty()) checkReport(task, results);
  Progress progress;
  std::size_t checked = 0;
  for (const DepthFrame* frame : frames) {
    stopIfInterrupted();
    readDepth(*frame);
    if (results.count(wholePath(frame->image)) != 0) {
      throw BadInput(frame->image.string() + ": would be overwritten by a result; choose another --out");
    }
    ++checked;
    progress.update(checked, static_cast<double>(checked) / static_cast<double>(frames.size()));
  }
}

void segmentAll(const DepthTask& task, const std::vector<const DepthFrame*>& frames) {
  std::vector<Slot> slots(task.jobs > 0 ? static_cast<std::size_t>(task.jobs) : slotsForAllCores());
  for (Slot& slot : slots) slot.segmenter.setParameters(task.parameters);
  Progress progress;
  std::size_t begun = 0, done = 0, out_of_range = 0;
  workInOrder(
      slots,
      [&](Slot& slot) {
        stopIfInterrupted();
        if (begun == frames.size()) return false;
        slot.frame = frames[begun++];
        slot.depth = readDepth(*slot.frame);
        return true;
      },
      work,
      [&](Slot& slot) {
        const FrameResults results(task.out, *slot.frame);
        OutputFiles files;
        files.add(results.labels, slot.labels);
        files.add(results.overlay, slot.overlay);
        files.add(results.planes, slot.planes);
        files.commit();
        progress.clear();
        std::printf("%s\n", slot.summary.c_str());
        std::fflush(stdout);
        ++done;
        out_of_range += slot.out_of_range ? 1 : 0;
        progress.update(done, static_cast<double>(done) / static_cast<double>(frames.size()));
      });
  progress.clear();
  if (out_of_range > 0) {
    std::fprintf(
        stderr,
        "segment_depth: in %zu of %zu images most depths lie outside of min_range to max_range: is the depth "
        "scale right?\n",
        out_of_range, done);
  }
}

}  // namespace

void segmentDepthImages(const DepthTask& task) {
  checkNames(task.frames);
  const std::vector<const DepthFrame*> frames = unfinished(task);
  checkInput(task, frames);
  makeOutputFolder(task.out);
  OutputFiles report;
  const fs::path report_file = task.report.empty() ? fs::path() : report.reserve(task.report);
  segmentAll(task, frames);
  const std::size_t finished = task.frames.size() - frames.size();
  if (finished > 0) std::printf("%zu frames were finished before; --redo does them again\n", finished);
  if (task.report.empty()) return;
  writeHtmlReport(report_file, task);
  report.commit();
}

}  // namespace line_plane_segmentation
