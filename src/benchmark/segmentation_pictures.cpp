// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_pictures.h"

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "output_files.h"
#include "overlay.h"
#include "report_program.h"

namespace line_plane_segmentation {
namespace {

using nlohmann::json;

std::vector<unsigned char> drawPng(const BenchmarkFrame& frame, std::vector<std::uint16_t> labels) {
  Segmentation segmentation;
  segmentation.width = frame.width;
  segmentation.height = frame.height;
  segmentation.labels = std::move(labels);
  std::vector<unsigned char> bytes;
  cv::imencode(".png", drawOverlay(frame.view(), segmentation, frame.camera), bytes);
  return bytes;
}

}  // namespace

void writeSegmentationPictures(const std::filesystem::path& folder, const std::vector<BenchmarkFrame>& frames,
                               const std::vector<BenchmarkMethod>& methods) {
  json sheet{{"rows", json::array()}, {"columns", json::array()}, {"pictures", json::array()}};
  for (const BenchmarkMethod& method : methods) sheet["columns"].push_back(method.name);
  OutputFiles files;
  for (const BenchmarkFrame& frame : frames) {
    json row = json::array();
    for (const BenchmarkMethod& method : methods) {
      const std::filesystem::path file = folder / (frame.name + "." + method.name + ".png");
      method.engine->load(frame);
      files.add(file, drawPng(frame, method.engine->labels()));
      row.push_back(pathForReport(file));
    }
    sheet["rows"].push_back(frame.name);
    sheet["pictures"].push_back(row);
  }
  files.commit();
  OutputFiles sheet_file;
  sheet_file.add(folder / "segmentations.png", makeReport("sheet", sheet));
  sheet_file.commit();
}

}  // namespace line_plane_segmentation
