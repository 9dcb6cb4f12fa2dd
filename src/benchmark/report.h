// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "scaling.h"

namespace line_plane_segmentation {

/// All that a run of the benchmark measured.
struct BenchmarkResults {
  std::vector<Measurement> frames;  ///< VGA and QVGA, say
  std::vector<Measurement> sizes, planes;
  std::vector<CameraLoad> cameras;
};

/// The paper's four tables and the scaling, as Markdown.
std::string markdownReport(const BenchmarkResults& results);

/// One row for each method on each frame: median, minimum, maximum [ms], planes, ratio.
std::string timesCsv(const std::vector<Measurement>& measurements);

/// One row for each stage of this method on each frame.
std::string stagesCsv(const std::vector<Measurement>& measurements);

/// The measurement of one method on one frame of one size; null if there is none.
const Measurement* find(const std::vector<Measurement>& all, const Measurement& on_frame_of,
                        const std::string& method);

/// The reference's median over the measurement's on the same frame; 0 if it was left out.
double ratioToReference(const std::vector<Measurement>& all, const Measurement& measurement);

}  // namespace line_plane_segmentation
