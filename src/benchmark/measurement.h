// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "benchmark_frame.h"
#include "contestants.h"

namespace line_plane_segmentation {

/// What many runs of the same came to [ms].
struct Statistics {
  double median = 0.0, min = 0.0, max = 0.0;
  int runs = 0;
};

/// @param times  of at least one run; the median of an even number is the mean of the middle two
Statistics statisticsOf(std::vector<double> times);

/// One method on one frame.
struct Measurement {
  std::string frame;
  int width = 0, height = 0;  ///< [px]
  std::string method;
  int planes = 0;
  Statistics total;
  std::vector<Statistics> stages;  ///< in the order of Stage; empty for methods without
};

struct MeasurementOptions {
  int repetitions = 20;      ///< runs of each method on each frame
  int slow_repetitions = 3;  ///< of those that are slow
  bool warm = false;         ///< each timed run follows one of the same method and frame, its caches filled
};

/// Runs every method on every frame, again and again: in a round each frame is handed to one method after the
/// other, so that a noisy minute of the machine hits all alike. A round that is not timed comes first; slow
/// methods sit it out.
/// @return frame by frame, in each by the order of the methods
std::vector<Measurement> measure(const std::vector<BenchmarkFrame>& frames,
                                 const std::vector<Contestant>& methods, const MeasurementOptions& options);

}  // namespace line_plane_segmentation
