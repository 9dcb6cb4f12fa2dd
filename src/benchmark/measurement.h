// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmark_frame.h"
#include "methods.h"

namespace line_plane_segmentation {

/// Statistics of the times of repeated runs [ms].
struct Statistics {
  double median = 0.0, min = 0.0, max = 0.0;
  double p90 = 0.0, p99 = 0.0;  ///< percentiles: the least time that this part of the runs does not exceed
  int runs = 0;
};

/// @param times  of at least one run; the median of an even number is the mean of the middle two
Statistics statisticsOf(std::vector<double> times);

/// Processor and wall time of the same runs.
struct ClockTimes {
  Statistics processor;
  Statistics wall;
};

/// One method on one frame.
struct Measurement {
  std::string frame;
  int width = 0, height = 0;  ///< [px]
  std::string method;
  int planes = 0;
  Statistics total;  ///< processor time, of the cold or the warm runs, by MeasurementOptions::warm
  std::vector<Statistics> stages;  ///< parts of `total` in the order of Stage; empty for methods without
  std::optional<ClockTimes> cold;  ///< runs after other methods and frames
  std::optional<ClockTimes>
      warm;  ///< runs directly after one of the same method and frame; none of slow methods
};

struct MeasurementOptions {
  int repetitions = 20;      ///< runs of each method on each frame
  int slow_repetitions = 3;  ///< the same for methods that are slow
  bool warm = false;         ///< `total` and `stages` are of the warm runs
};

/// Runs every method on every frame repeatedly. In a round, each frame is given to one method after the
/// other, so that other load of the machine affects all methods alike. Each method runs twice: cold, then
/// warm; slow methods only cold. The first round, without the slow methods, is not timed.
/// @return by frame, and for each frame in the order of the methods
std::vector<Measurement> measure(const std::vector<BenchmarkFrame>& frames,
                                 const std::vector<BenchmarkMethod>& methods,
                                 const MeasurementOptions& options);

}  // namespace line_plane_segmentation
