// SPDX-License-Identifier: BSD-3-Clause
// In simulated rooms, whose planes are known exactly, ids stay with their planes while the camera moves, and
// following them takes little time.
#include <gtest/gtest.h>

#include <cstdint>
#include <ctime>
#include <iostream>
#include <map>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "line_plane_segmentation/plane_tracker.h"
#include "region_overlap.h"
#include "simulated_camera.h"
#include "support/median.h"

namespace line_plane_segmentation {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr std::int64_t kMinPixels = 2200;  // the segmenter looks for no smaller ones
constexpr std::uint64_t kRooms = 4;
constexpr int kFrames = 150;
constexpr double kRate = 30.0;

/// Follows the ids that true planes have over time.
class IdentityJudge {
 public:
  /// A plane has the id of the region that shares over half of their common pixels; there is one at most.
  void judge(const RegionOverlaps& regions, const std::vector<std::uint32_t>& ids, double seconds) {
    for (const Overlap& overlap : regions.overlaps) {
      const CountedRegion& plane = regions.truth[overlap.truth];
      const CountedRegion& region = regions.labels[overlap.label];
      if (plane.pixels < kMinPixels || 3 * overlap.pixels <= plane.pixels + region.pixels) continue;
      ++plane_frames;
      const std::uint32_t id = ids[region.value - 1U];
      if (known(plane.value, seconds) && id_of_[plane.value] != id) ++switches;
      if (plane_of_.count(id) != 0 && plane_of_[id] != plane.value) ++transfers;
      id_of_[plane.value] = id;
      plane_of_[id] = plane.value;
    }
    for (const CountedRegion& plane : regions.truth) {
      if (plane.pixels >= kMinPixels) last_visible_[plane.value] = seconds;
    }
  }

  int plane_frames = 0;
  int switches = 0;   // a plane has another id than before
  int transfers = 0;  // an id is another plane's than before

 private:
  // Ids need to stay as long as the plane is in view, found or not, and for the memory's time after that.
  bool known(std::uint16_t plane, double seconds) const {
    const auto visible = last_visible_.find(plane);
    return id_of_.count(plane) != 0 && visible != last_visible_.end() &&
           seconds - visible->second <= TrackingParameters{}.track_memory;
  }

  std::map<std::uint16_t, std::uint32_t> id_of_;
  std::map<std::uint32_t, std::uint16_t> plane_of_;
  std::map<std::uint16_t, double> last_visible_;
};

template <typename Function>
double millisecondsOf(Function&& function) {
  // Processor time, since others may use the processor meanwhile.
  const std::clock_t start = std::clock();
  function();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Totals {
  int plane_frames = 0, switches = 0, transfers = 0;

  void add(const IdentityJudge& judge) {
    plane_frames += judge.plane_frames;
    switches += judge.switches;
    transfers += judge.transfers;
  }

  double switchesIn100() const { return 100.0 * switches / plane_frames; }
  double transfersIn100() const { return 100.0 * transfers / plane_frames; }
};

class TrackingQuality : public testing::Test {
 protected:
  void runRoom(std::uint64_t room) {
    simulation::SimulatedCamera camera({room, kWidth, kHeight, true});
    PlaneTracker trackers[2];
    IdentityJudge judges[2];
    for (int frame = 0; frame < kFrames; ++frame) {
      const double seconds = frame / kRate;
      const simulation::Rendering& rendering =
          camera.capture(static_cast<std::uint64_t>(frame), seconds, depth_.data());
      const Segmentation* segmentation = nullptr;
      segmenting_.push_back(millisecondsOf([&] {
        segmentation = &segmenter_.segment(viewOf(depth_.data(), kWidth, kHeight), camera.intrinsics());
      }));
      std::vector<std::uint16_t> truth = rendering.labels;
      for (std::size_t i = 0; i < truth.size(); ++i) {
        if (depth_[i] == 0) truth[i] = kDoNotJudge;
      }
      const RegionOverlaps regions = countOverlaps(truth.data(), segmentation->labels.data(), truth.size());
      const Eigen::Isometry3d motion = camera.pose(seconds).inverse() * camera.pose(seconds - 1.0 / kRate);
      for (const int known : {0, 1}) {
        const std::vector<std::uint32_t>* ids = nullptr;
        tracking_.push_back(millisecondsOf([&] {
          ids =
              &trackers[known].track(*segmentation, camera.intrinsics(), seconds, known ? &motion : nullptr);
        }));
        judges[known].judge(regions, *ids, seconds);
      }
    }
    for (const int known : {0, 1}) totals_[known].add(judges[known]);
  }

  PlaneSegmenter segmenter_;
  std::vector<std::uint16_t> depth_ = std::vector<std::uint16_t>(std::size_t{kWidth} * kHeight);
  std::vector<double> segmenting_, tracking_;  // [ms] of each frame
  Totals totals_[2];                           // by whether the motion is known
};

TEST_F(TrackingQuality, keepsIdsAtLittleCost) {
  for (std::uint64_t room = 1; room <= kRooms; ++room) runRoom(room);
  for (const int known : {0, 1}) {
    const Totals& totals = totals_[known];
    std::cout << (known != 0 ? "motion known: " : "image alone:  ") << totals.plane_frames
              << " plane-frames, " << totals.switchesIn100() << " identity switches and "
              << totals.transfersIn100() << " ids passed on in 100\n";
    EXPECT_GT(totals.plane_frames, 3000);
    EXPECT_LT(totals.switchesIn100(), 1.0);
    EXPECT_LT(totals.transfersIn100(), 1.0);
  }
  const double tracking = median(tracking_), segmenting = median(segmenting_);
  std::cout << "tracking " << tracking << " ms a frame (median), segmentation " << segmenting << " ms\n";
  EXPECT_LT(tracking, 0.05 * segmenting);
}

}  // namespace
}  // namespace line_plane_segmentation
