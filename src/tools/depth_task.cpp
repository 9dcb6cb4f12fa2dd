// SPDX-License-Identifier: BSD-3-Clause
#include "depth_task.h"

#include <climits>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>

#include "frame_results.h"
#include "interruption.h"
#include "line_plane_segmentation/palette.h"
#include "line_plane_segmentation/plane_segmenter.h"
#include "ordered_work.h"
#include "output_files.h"
#include "overlay.h"
#include "planes_json.h"
#include "progress.h"
#include "report_program.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<unsigned char>;
using nlohmann::json;

/// A frame in progress, and its results.
struct Slot {
  const DepthFrame* frame = nullptr;
  Bytes file;  // content of the image's file
  cv::Mat depth;
  PlaneSegmenter segmenter;
  Bytes labels, overlay;
  std::string planes;
  std::string summary;
  bool out_of_range = false;  // most of its depths, as with wrong units
};

Bytes encodePng(const cv::Mat& image) {
  Bytes bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

std::string summaryOf(const DepthFrame& frame, const Segmentation& segmentation, const StageClock& clock) {
  const double percent =
      segmentation.valid_pixels == 0 ? 0.0 : 100.0 * segmentation.assigned_pixels / segmentation.valid_pixels;
  char figures[96];
  std::snprintf(figures, sizeof figures, ": %zu planes, %.0f %% of the depth, %.2f ms",
                segmentation.planes.size(), percent, clock.totalMilliseconds());
  return frame.name + figures;
}

void work(Slot& slot) {
  const DepthFrame& frame = *slot.frame;
  StageClock clock;
  const DepthView view = depthViewOf(slot.depth, frame.depth_unit);
  Segmentation result = slot.segmenter.segment(view, frame.camera, &clock);
  slot.labels = encodePng(cv::Mat(result.height, result.width, CV_16UC1, result.labels.data()));
  slot.overlay = encodePng(drawOverlay(view, result, frame.camera));
  slot.planes = planesJson(frame.name, result, clock,
                           provenanceOf(frame, settingsOf(frame, slot.segmenter.parameters()),
                                        {slot.file, slot.labels, slot.overlay}));
  slot.summary = summaryOf(frame, result, clock);
  slot.out_of_range = 2 * std::int64_t{result.valid_pixels} < cv::countNonZero(slot.depth > 0);
}

std::vector<const DepthFrame*> unfinishedFrames(const DepthTask& task) {
  std::vector<const DepthFrame*> frames;
  for (const DepthFrame& frame : task.frames) {
    stopIfInterrupted();
    const FrameResults results(task.out, frame);
    const ResultState state =
        task.redo ? ResultState::kUnfinished : stateOf(results, frame, settingsOf(frame, task.parameters));
    if (state == ResultState::kForeign) {
      throw BadInput(
          results.planes.string() +
          ": was made from another image of this name; choose another --out, or replace it with --redo");
    }
    if (state == ResultState::kUnfinished) frames.push_back(&frame);
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

void checkNameLength(const fs::path& result) {
  if (result.filename().string().size() > NAME_MAX) {
    throw BadInput(result.string() + ": this name of a result is too long, more than " +
                   std::to_string(NAME_MAX) + " bytes");
  }
}

// Everything that can be checked before anything is written.
void checkInput(const DepthTask& task, const std::vector<const DepthFrame*>& frames) {
  std::set<fs::path> results;
  for (const DepthFrame& frame : task.frames) {
    for (const fs::path& file : FrameResults(task.out, frame).all()) {
      checkNameLength(file);
      results.insert(wholePath(file));
    }
  }
  if (!task.report.empty()) checkReport(task, results);
  for (const DepthFrame* frame : frames) {
    stopIfInterrupted();
    checkDepthFile(frame->image, frame->max_pixels);
    if (results.count(wholePath(frame->image)) != 0) {
      throw BadInput(frame->image.string() + ": would be overwritten by a result; choose another --out");
    }
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
        slot.file = readFile(slot.frame->image);
        slot.depth = decodeDepth(slot.file, *slot.frame);
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
        "unit right?\n",
        out_of_range, done);
  }
}

// Input of the report program: the frames' files, and the parameters beside their defaults.
json reportData(const DepthTask& task) {
  json data{{"parameters", settingsOf({}, task.parameters).at("parameters")},
            {"defaults", settingsOf({}, {}).at("parameters")},
            {"frames", json::array()},
            {"stages", json::array()},
            {"colors", json::array()}};
  for (int i = 0; i < kStageCount; ++i) data["stages"].push_back(nameOf(static_cast<Stage>(i)));
  for (std::uint32_t label = 1; label <= kPaletteSize; ++label) {
    const Color color = colorOf(label);
    data["colors"].push_back({color.r, color.g, color.b});
  }
  for (const DepthFrame& frame : task.frames) {
    const FrameResults results(task.out, frame);
    data["frames"].push_back(
        {{"planes", pathForReport(results.planes)}, {"overlay", pathForReport(results.overlay)}});
  }
  return data;
}

}  // namespace

void segmentDepthImages(const DepthTask& task) {
  const std::vector<const DepthFrame*> frames = unfinishedFrames(task);
  checkInput(task, frames);
  OutputFiles report;
  for (const DepthFrame& frame : task.frames) report.protect(frame.image);
  if (!task.table.empty()) report.protect(task.table);
  if (!task.report.empty()) report.checkProtected(task.report);
  makeOutputFolder(task.out);
  if (!task.report.empty()) report.add(task.report, std::string());
  segmentAll(task, frames);
  const std::size_t finished = task.frames.size() - frames.size();
  if (finished > 0) std::printf("%zu frames were finished before; --redo segments them again\n", finished);
  if (task.report.empty()) return;
  report.append(task.report, makeReport("html", reportData(task)));
  report.commit();
}

}  // namespace line_plane_segmentation
