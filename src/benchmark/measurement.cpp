// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "processor_clock.h"

namespace line_plane_segmentation {
namespace {

/// Times of repeated runs of one method on one frame [ms].
struct Runs {
  std::vector<double> processor, wall;
  std::vector<std::vector<double>> stages;
};

struct Samples {
  Runs cold, warm;
  int planes = 0;
};

double wallMilliseconds() {
  using Milliseconds = std::chrono::duration<double, std::milli>;
  return Milliseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int runOnce(Engine& engine, Runs& runs) {
  const double wall_start = wallMilliseconds();
  const double start = processorMilliseconds();
  const int planes = engine.segment();
  runs.processor.push_back(processorMilliseconds() - start);
  runs.wall.push_back(wallMilliseconds() - wall_start);

  if (const StageTimes* stages = engine.stageTimes()) {
    runs.stages.resize(stages->size());
    for (std::size_t i = 0; i < stages->size(); ++i) runs.stages[i].push_back((*stages)[i]);
  }
  return planes;
}

std::optional<ClockTimes> clockTimesOf(const Runs& runs) {
  if (runs.processor.empty()) return std::nullopt;
  return ClockTimes{statisticsOf(runs.processor), statisticsOf(runs.wall)};
}

Measurement summarise(const BenchmarkFrame& frame, const std::string& method, const Samples& samples,
                      bool warm) {
  Measurement result;
  result.frame = frame.name;
  result.width = frame.width;
  result.height = frame.height;
  result.method = method;
  result.planes = samples.planes;
  result.cold = clockTimesOf(samples.cold);
  result.warm = clockTimesOf(samples.warm);
  const Runs& shown = warm && result.warm ? samples.warm : samples.cold;
  result.total = statisticsOf(shown.processor);
  for (const std::vector<double>& stage : shown.stages) result.stages.push_back(statisticsOf(stage));
  return result;
}

}  // namespace

Statistics statisticsOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const std::size_t count = times.size(), middle = count / 2;
  const double median = count % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
  const auto percentile = [&times, count](double fraction) {
    return times[static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(count))) - 1];
  };
  return {median, times.front(), times.back(), percentile(0.9), percentile(0.99), static_cast<int>(count)};
}

std::vector<Measurement> measure(const std::vector<BenchmarkFrame>& frames,
                                 const std::vector<BenchmarkMethod>& methods,
                                 const MeasurementOptions& options) {
  std::vector<Samples> samples(frames.size() * methods.size());
  constexpr int kWarmUp = -1;
  for (int round = kWarmUp; round < std::max(options.repetitions, options.slow_repetitions); ++round) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const BenchmarkFrame& frame = frames[i / methods.size()];
      const BenchmarkMethod& method = methods[i % methods.size()];
      if (round >= (method.is_slow ? options.slow_repetitions : options.repetitions)) continue;
      if (round == kWarmUp && method.is_slow) continue;
      method.engine->load(frame);
      if (round == kWarmUp) {
        method.engine->segment();
        continue;
      }
      samples[i].planes = runOnce(*method.engine, samples[i].cold);
      if (!method.is_slow) runOnce(*method.engine, samples[i].warm);
    }
  }

  std::vector<Measurement> results;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    results.push_back(
        summarise(frames[i / methods.size()], methods[i % methods.size()].name, samples[i], options.warm));
  }
  return results;
}

}  // namespace line_plane_segmentation
