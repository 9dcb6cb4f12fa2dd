// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "measurement.h"
#include "scaling.h"

namespace line_plane_segmentation {

/// Results of a run of the benchmark.
struct BenchmarkResults {
  std::vector<Measurement> frames;         ///< at full size, and at half the size
  std::vector<Measurement> sizes, planes;  ///< empty if not measured
  std::vector<CameraLoad> cameras;         ///< empty if not measured
};

/// The results as report/tables.py and report/plots.py read them.
nlohmann::json reportData(const BenchmarkResults& results);

/// The same for scaling.csv: the measurements of `sizes` and `planes` in place of `frames`.
nlohmann::json scalingData(const BenchmarkResults& results);

/// Statistics as an object.
nlohmann::json toJson(const Statistics& statistics);

}  // namespace line_plane_segmentation
