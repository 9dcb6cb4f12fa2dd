// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "image_file.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

void checkFolder(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw BadInput(folder.string() + ": no such folder");
}

std::vector<fs::path> pngFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path labelFile(const fs::path& folder, const std::string& frame) {
  for (const char* ending : {".labels.png", ".png"}) {
    const fs::path file = folder / (frame + ending);
    if (fs::exists(file)) return file;
  }
  throw BadInput(folder.string() + ": has neither " + frame + ".labels.png nor " + frame + ".png");
}

}  // namespace

std::vector<EvaluatedFrame> countFolders(const fs::path& truth, const fs::path& labels) {
  checkFolder(truth);
  checkFolder(labels);
  std::vector<EvaluatedFrame> frames;
  for (const fs::path& truth_file : pngFiles(truth)) {
    const std::string name = truth_file.stem().string();
    const fs::path label_file = labelFile(labels, name);
    const cv::Mat truth_image = readImage16(truth_file);
    const cv::Mat label_image = readImage16(label_file);
    if (truth_image.size() != label_image.size()) {
      throw BadInput(label_file.string() + ": differs in size from " + truth_file.string());
    }
    CV_Assert(truth_image.isContinuous() && label_image.isContinuous());
    frames.push_back({name, countOverlaps(truth_image.ptr<std::uint16_t>(), label_image.ptr<std::uint16_t>(),
                                          truth_image.total())});
  }
  if (frames.empty()) throw BadInput(truth.string() + ": no PNG in this folder");
  return frames;
}

Scores scoreOf(const EvaluatedFrame& frame, const EvaluationSettings& settings) {
  return {classifyRegions(frame.regions, settings.tolerance, settings.min_pixels),
          scoreIou(frame.regions, settings.min_pixels)};
}

Scores scoreOf(const std::vector<EvaluatedFrame>& frames, const EvaluationSettings& settings) {
  Scores sum;
  for (const EvaluatedFrame& frame : frames) {
    const Scores scores = scoreOf(frame, settings);
    sum.hoover += scores.hoover;
    sum.iou += scores.iou;
  }
  return sum;
}

std::vector<CurvePoint> toleranceCurve(const std::vector<EvaluatedFrame>& frames, std::int64_t min_pixels) {
  std::vector<CurvePoint> curve;
  for (int hundredths = 52; hundredths <= 98; hundredths += 2) {
    CurvePoint point{hundredths / 100.0, {}};
    for (const EvaluatedFrame& frame : frames)
      point.counts += classifyRegions(frame.regions, point.tolerance, min_pixels);
    curve.push_back(point);
  }
  return curve;
}

}  // namespace line_plane_segmentation
