// SPDX-License-Identifier: BSD-3-Clause
#include "scaling.h"

#include <memory>
#include <utility>

#include "frame_sources.h"
#include "line_primitive_engine.h"
#include "processor_clock.h"

namespace line_plane_segmentation {
namespace {

constexpr int kVgaWidth = 640;
constexpr int kVgaHeight = 480;

const std::vector<std::string> kCompared{"adaptive", "paper_1", kReferenceName};

}  // namespace

std::vector<Measurement> measureSizes(const MeasurementOptions& options) {
  const std::vector<std::pair<int, int>> sizes{{160, 120}, {320, 240},  {480, 360},  {640, 480},
                                               {960, 540}, {1280, 720}, {1920, 1080}};
  std::vector<BenchmarkFrame> frames;
  for (const auto& [width, height] : sizes) frames.push_back(simulatedRooms(1, width, height).front());
  return measure(frames, selectMethods(kCompared), options);
}

std::vector<Measurement> measurePlanes(const MeasurementOptions& options) {
  std::vector<BenchmarkFrame> frames;
  for (const int planes : {0, 1, 2, 5, 10, 20, 30, 40, 50}) {
    frames.push_back(simulatedTiles(planes, kVgaWidth, kVgaHeight));
  }
  return measure(frames, selectMethods(kCompared), options);
}

std::vector<CameraLoad> measureCameras(const MeasurementOptions& options) {
  constexpr int kMostCameras = 8;
  const std::vector<BenchmarkFrame> frames = simulatedRooms(kMostCameras, kVgaWidth, kVgaHeight);
  std::vector<std::unique_ptr<Engine>> engines;
  for (const BenchmarkFrame& frame : frames) {
    engines.push_back(makeLinePrimitiveEngine({}));
    engines.back()->load(frame);
    engines.back()->segment();
  }

  std::vector<std::vector<double>> times(kMostCameras);
  for (int round = 0; round < options.repetitions; ++round) {
    for (std::size_t cameras = 1; cameras <= engines.size(); ++cameras) {
      const double start = processorMilliseconds();
      for (std::size_t i = 0; i < cameras; ++i) engines[i]->segment();
      times[cameras - 1].push_back(processorMilliseconds() - start);
    }
  }
  std::vector<CameraLoad> loads;
  for (const std::vector<double>& samples : times) {
    loads.push_back({static_cast<int>(loads.size()) + 1, statisticsOf(samples)});
  }
  return loads;
}

}  // namespace line_plane_segmentation
