// SPDX-License-Identifier: BSD-3-Clause
#include "frame_results.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;

}  // namespace

FrameResults::FrameResults(const fs::path& folder, const DepthFrame& frame)
    : labels(folder / (frame.name + ".labels.png")),
      overlay(folder / (frame.name + ".overlay.png")),
      planes(folder / (frame.name + ".planes.json")) {}

nlohmann::json settingsOf(const DepthFrame& frame, const Parameters& parameters) {
  nlohmann::json values;
  visitParameters(parameters, [&values](const char* name, auto value, auto, auto) {
    if constexpr (std::is_same_v<decltype(value), Method>) {
      values[name] = value == Method::kPaper ? "paper" : "adaptive";
    } else {
      values[name] = value;
    }
  });
  const CameraIntrinsics& camera = frame.camera;
  return {{"camera", {camera.fx, camera.fy, camera.cx, camera.cy}},
          {"units_per_metre", frame.units_per_metre},
          {"parameters", values},
          {"version", LPS_VERSION}};
}

bool areFinished(const FrameResults& results, const DepthFrame& frame, const nlohmann::json& settings) {
  std::error_code error;
  const auto image_time = fs::last_write_time(frame.image, error);
  if (error) return false;
  for (const fs::path& file : results.all()) {
    const auto time = fs::last_write_time(file, error);
    if (error || time < image_time) return false;
  }
  std::ifstream stream(results.planes);
  const nlohmann::json document = nlohmann::json::parse(stream, nullptr, false);
  return document.is_object() && document.value("settings", nlohmann::json()) == settings;
}

}  // namespace line_plane_segmentation
