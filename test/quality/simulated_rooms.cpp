// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_rooms.h"

#include <cstdio>

#include "region_overlap.h"
#include "simulated_camera.h"

namespace line_plane_segmentation {
namespace {

using simulation::Rendering;
using simulation::SimulatedCamera;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kTimes[] = {0, 5, 10, 15};  // [s]

std::string nameOf(std::uint64_t room, int seconds) {
  char name[32];
  std::snprintf(name, sizeof name, "room%02d_%02ds", static_cast<int>(room), seconds);
  return name;
}

std::vector<std::uint16_t> judgedTruth(const Rendering& rendering, const std::vector<std::uint16_t>& depth) {
  std::vector<std::uint16_t> truth = rendering.labels;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (depth[i] == 0) truth[i] = kDoNotJudge;
  }
  return truth;
}

}  // namespace

LabelledFrame SimulatedFrame::labelled() const {
  const auto image_of = [this](const std::vector<std::uint16_t>& pixels) {
    return cv::Mat(height(), width(), CV_16UC1, const_cast<std::uint16_t*>(pixels.data())).clone();
  };
  return {name, image_of(depth), image_of(truth), camera, 0.001};
}

void forEachSimulatedFrame(const RoomRange& rooms, const std::function<void(const SimulatedFrame&)>& visit) {
  std::vector<std::uint16_t> depth(std::size_t{kWidth} * kHeight);
  for (std::uint64_t room = rooms.first; room <= rooms.last; room += rooms.step) {
    SimulatedCamera camera({room, kWidth, kHeight, true});
    for (const int seconds : kTimes) {
      const auto frame_number = static_cast<std::uint64_t>(30 * seconds);
      const Rendering& rendering = camera.capture(frame_number, seconds, depth.data());
      const std::vector<std::uint16_t> truth = judgedTruth(rendering, depth);
      visit({nameOf(room, seconds), depth, truth, rendering, camera.intrinsics()});
    }
  }
}

}  // namespace line_plane_segmentation
