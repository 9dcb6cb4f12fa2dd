// SPDX-License-Identifier: BSD-3-Clause
#include "frame_results.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>

#include "digest.h"
#include "output_files.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Bytes = std::vector<unsigned char>;

json recordOf(const Bytes& bytes) { return {{"bytes", bytes.size()}, {"sha256", sha256(bytes)}}; }

// True if the file has the recorded size and content. Reads it only if the size is right.
bool isRecorded(const fs::path& file, const json& record) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || !record.is_object() || record.value("bytes", json()) != size) return false;
  try {
    return record.value("sha256", "") == sha256(readFile(file));
  } catch (const std::exception&) {
    return false;
  }
}

bool isOlder(const fs::path& file, const fs::path& image) {
  std::error_code error;
  const auto image_time = fs::last_write_time(image, error);
  if (error) return true;
  const auto time = fs::last_write_time(file, error);
  return error || time < image_time;
}

}  // namespace

FrameResults::FrameResults(const fs::path& folder, const DepthFrame& frame)
    : labels(folder / (frame.name + ".labels.png")),
      overlay(folder / (frame.name + ".overlay.png")),
      planes(folder / (frame.name + ".planes.json")) {}

// Whole numbers are what users give: the inverse of their inverse may differ in the last bit.
double unitsPerMetre(double depth_unit) {
  const double units = 1.0 / depth_unit, whole = std::round(units);
  return std::abs(units - whole) < 1e-9 * whole ? whole : units;
}

json settingsOf(const DepthFrame& frame, const Parameters& parameters) {
  json values;
  visitParameters(parameters, [&values](const char* name, auto value, auto, auto) {
    if constexpr (std::is_same_v<decltype(value), Method>) {
      values[name] = nameOf(value);
    } else {
      values[name] = value;
    }
  });
  const CameraIntrinsics& camera = frame.camera;
  return {{"camera", {camera.fx, camera.fy, camera.cx, camera.cy}},
          {"depth_unit", frame.depth_unit},
          {"units_per_metre", unitsPerMetre(frame.depth_unit)},  // older name of the same
          {"parameters", values},
          {"version", LPS_VERSION}};
}

json provenanceOf(const DepthFrame& frame, const json& settings, const FrameFiles& files) {
  json input = recordOf(files.image);
  input["path"] = wholePath(frame.image).string();
  return {{"settings", settings},
          {"input", input},
          {"outputs", {{"labels", recordOf(files.labels)}, {"overlay", recordOf(files.overlay)}}}};
}

ResultState stateOf(const FrameResults& results, const DepthFrame& frame, const json& settings) try {
  std::error_code error;
  if (!fs::exists(frame.image, error)) return ResultState::kUnfinished;
  std::ifstream stream(results.planes);
  const json document = json::parse(stream, nullptr, false);
  if (!document.is_object() || !document.contains("input") || !document["input"].is_object()) {
    return ResultState::kUnfinished;
  }
  const json& input = document["input"];
  if (!isRecorded(frame.image, input)) {
    const bool same_path = input.value("path", "") == wholePath(frame.image).string();
    return same_path ? ResultState::kUnfinished : ResultState::kForeign;
  }
  const json outputs = document.value("outputs", json::object());
  json recorded = document.value("settings", json::object());
  // Results of earlier versions have units_per_metre only.
  recorded.emplace("depth_unit", settings.at("depth_unit"));
  const bool finished = recorded == settings && isRecorded(results.labels, outputs.value("labels", json())) &&
                        isRecorded(results.overlay, outputs.value("overlay", json())) &&
                        !isOlder(results.planes, frame.image);
  return finished ? ResultState::kFinished : ResultState::kUnfinished;
} catch (const json::exception&) {  // a member of another type
  return ResultState::kUnfinished;
}

}  // namespace line_plane_segmentation
