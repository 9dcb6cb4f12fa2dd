// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <nlohmann/json.hpp>

#include "machine.h"

namespace line_plane_segmentation {
namespace {

using nlohmann::json;
using Measurements = std::vector<Measurement>;

json toJson(const Measurement& m) {
  json stages = json::object();
  for (std::size_t i = 0; i < m.stages.size(); ++i) {
    stages[nameOf(static_cast<Stage>(i))] = toJson(m.stages[i]);
  }
  json document{{"frame", m.frame},   {"width", m.width}, {"height", m.height},      {"method", m.method},
                {"planes", m.planes}, {"stages", stages}, {"total", toJson(m.total)}};
  const auto add = [&document](const std::string& name, const std::optional<ClockTimes>& times) {
    if (!times) return;
    document[name] = toJson(times->processor);
    document[name + "_wall"] = toJson(times->wall);
  };
  add("cold", m.cold);
  add("warm", m.warm);
  return document;
}

json toJson(const Measurements& measurements) {
  json list = json::array();
  for (const Measurement& m : measurements) list.push_back(toJson(m));
  return list;
}

json withNames(json document) {
  document["reference"] = kReferenceName;
  document["stage_names"] = json::array();
  for (int i = 0; i < kStageCount; ++i) document["stage_names"].push_back(nameOf(static_cast<Stage>(i)));
  return document;
}

}  // namespace

json toJson(const Statistics& s) {
  return {{"median", s.median}, {"min", s.min}, {"max", s.max},
          {"p90", s.p90},       {"p99", s.p99}, {"runs", s.runs}};
}

json reportData(const BenchmarkResults& results) {
  json cameras = json::array();
  for (const CameraLoad& load : results.cameras) {
    cameras.push_back({{"cameras", load.cameras}, {"round", toJson(load.round)}});
  }
  return withNames({{"machine", describeMachine()},
                    {"frames", toJson(results.frames)},
                    {"sizes", toJson(results.sizes)},
                    {"planes", toJson(results.planes)},
                    {"cameras", cameras}});
}

json scalingData(const BenchmarkResults& results) {
  Measurements scaling = results.sizes;
  scaling.insert(scaling.end(), results.planes.begin(), results.planes.end());
  return withNames({{"frames", toJson(scaling)}});
}

}  // namespace line_plane_segmentation
