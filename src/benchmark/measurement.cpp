// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.h"

#include <algorithm>

#include "processor_clock.h"

namespace line_plane_segmentation {
namespace {

/// The times of one method on one frame.
struct Samples {
  std::vector<double> total;
  std::vector<std::vector<double>> stages;
  int planes = 0;
};

void runOnce(Engine& engine, Samples& samples) {
  const double start = processorMilliseconds();
  samples.planes = engine.segment();
  samples.total.push_back(processorMilliseconds() - start);

  const StageTimes* stages = engine.stageTimes();
  if (stages == nullptr) return;
  samples.stages.resize(stages->size());
  for (std::size_t i = 0; i < stages->size(); ++i) samples.stages[i].push_back((*stages)[i]);
}

Measurement summarise(const BenchmarkFrame& frame, const std::string& method, const Samples& samples) {
  Measurement result{frame.name, frame.width, frame.height, method, samples.planes, {}, {}};
  result.total = statisticsOf(samples.total);
  for (const std::vector<double>& stage : samples.stages) result.stages.push_back(statisticsOf(stage));
  return result;
}

}  // namespace

Statistics statisticsOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const std::size_t middle = times.size() / 2;
  const double median = times.size() % 2 == 1 ? times[middle] : 0.5 * (times[middle - 1] + times[middle]);
  return {median, times.front(), times.back(), static_cast<int>(times.size())};
}

std::vector<Measurement> measure(const std::vector<BenchmarkFrame>& frames,
                                 const std::vector<Contestant>& methods, const MeasurementOptions& options) {
  std::vector<Samples> samples(frames.size() * methods.size());
  constexpr int kWarmUp = -1;
  for (int round = kWarmUp; round < std::max(options.repetitions, options.slow_repetitions); ++round) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const BenchmarkFrame& frame = frames[i / methods.size()];
      const Contestant& method = methods[i % methods.size()];
      if (round >= (method.is_slow ? options.slow_repetitions : options.repetitions)) continue;
      if (round == kWarmUp && method.is_slow) continue;
      method.engine->load(frame);
      if (round == kWarmUp || (options.warm && !method.is_slow)) method.engine->segment();
      if (round != kWarmUp) runOnce(*method.engine, samples[i]);
    }
  }

  std::vector<Measurement> results;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    results.push_back(summarise(frames[i / methods.size()], methods[i % methods.size()].name, samples[i]));
  }
  return results;
}

}  // namespace line_plane_segmentation
