// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/surface_parts.h"

#include <algorithm>
#include <utility>

namespace line_plane_segmentation {
namespace {

// A part lies in a plane if so large a share of its samples is seen there, ...
constexpr double kShare = 0.6;
constexpr int kFewestSamples = 2;
// ... at this angle and this distance, as a share of the depth, at most: what noise does to small planes.
constexpr double kMaxAngle = 0.1;      // [rad]
constexpr double kMaxDistance = 0.02;  // [-]

// A part takes the surface's id from another one that is so many times smaller.
constexpr std::uint32_t kMuchLarger = 2;

bool liesIn(const PlaneTrack& track, int in_view, const SegmentedPlane& plane, const SampleVotes& shared) {
  return shared.samples >= kFewestSamples && shared.samples >= kShare * in_view &&
         shared.distance <= kMaxDistance * shared.samples &&
         angleBetween(track.normal, plane.normal) <= kMaxAngle;
}

void join(std::uint32_t a, std::uint32_t b, std::vector<PlaneTrack>& tracks) {
  for (PlaneTrack& track : tracks) {
    if (track.surface == a || track.surface == b) track.surface = std::min(a, b);
  }
}

}  // namespace

void joinParts(const std::vector<SegmentedPlane>& planes, const std::vector<int>& track_of,
               const VoteTable& votes, std::vector<PlaneTrack>& tracks) {
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (tracks[t].plane >= 0) continue;
    for (const SampleVotes* shared = votes.begin(t); shared != votes.end(t); ++shared) {
      const auto k = static_cast<std::size_t>(shared->plane);
      if (k >= track_of.size() || track_of[k] < 0) continue;
      if (!liesIn(tracks[t], votes.inView(t), planes[k], *shared)) continue;
      join(tracks[t].surface, tracks[track_of[k]].surface, tracks);
    }
  }
}

void passIdsOn(std::size_t first_seen, std::vector<PlaneTrack>& tracks) {
  const auto seen = tracks.begin() + static_cast<std::ptrdiff_t>(first_seen);
  for (auto part = seen; part != tracks.end(); ++part) {
    const std::uint32_t surface = part->surface;
    const auto is_part = [surface](const PlaneTrack& track) { return track.surface == surface; };
    if (std::find_if(seen, part, is_part) != part) continue;  // this surface was dealt with
    auto largest = part;
    for (auto other = part; other != tracks.end(); ++other) {
      if (is_part(*other) && other->pixels > largest->pixels) largest = other;
    }
    const auto holder = std::find_if(tracks.begin(), tracks.end(),
                                     [surface](const PlaneTrack& track) { return track.id == surface; });
    if (holder == tracks.end()) {
      largest->id = surface;  // who had it is forgotten
    } else if (holder < seen || largest->pixels > kMuchLarger * holder->pixels) {
      std::swap(largest->id, holder->id);
    }
  }
}

}  // namespace line_plane_segmentation
