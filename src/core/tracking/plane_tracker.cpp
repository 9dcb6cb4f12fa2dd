// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_tracker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tracking/plane_samples.h"
#include "tracking/plane_track.h"
#include "tracking/surface_parts.h"

namespace line_plane_segmentation {
namespace {

// What is remembered of planes that are not seen, at most: then the oldest are forgotten.
constexpr std::size_t kMaxLostTracks = 128;
constexpr std::size_t kMaxLostSamples = 4096;

// A new plane is often seen where another one was, at its border.
constexpr double kMinOverlap = 0.05;

// A plane that was just seen goes before one that was not seen for a while, unless that fits much better.
constexpr double kLostWeight = 0.7;

// How fast a pair's score falls with the square of what it is off, as a share of what it may be.
constexpr double kDisagreement = 2.0;

// Where no point is shared the coefficients have to agree so much better, and the planes must not be farther
// apart than this many times their size.
constexpr double kStrictness = 1.0 / 3.0;
constexpr double kReach = 2.0;

struct Pair {
  double score;
  int track;
  int plane;
};

// 1 where nothing is off, 0 beyond the bounds.
double agreement(double angle, double max_angle, double distance, double max_distance) {
  const double a = angle / max_angle, b = distance / max_distance;
  return a < 1.0 && b < 1.0 ? std::exp(-kDisagreement * (a * a + b * b)) : 0.0;
}

}  // namespace

struct PlaneTracker::Memory {
  double max_angle = 0.0;     // [rad]
  double max_distance = 0.0;  // [-]
  double memory = 0.0;        // [s]
  bool tracking = true;

  std::uint32_t last_id = 0;
  double last_image = 0.0;  // [s]
  std::vector<PlaneTrack>
      tracks;  // those that were not seen in the last image come first, the oldest before all
  std::vector<PlaneSample> samples;  // of the tracks

  // Of this image:
  std::vector<std::uint32_t> ids;
  std::size_t tracked = 0;        // its first planes, which are tracked
  std::vector<int> track_of;      // of each of them; -1 = none
  std::vector<PlaneSample> seen;  // of its planes
  std::vector<int> seen_count;    // of each plane

  // Scratch.
  VoteTable votes;  // of the samples of each track
  std::vector<Pair> pairs;
  std::vector<PlaneTrack> next_tracks;
  std::vector<PlaneSample> next_samples;
  std::vector<int> next_index;

  void move(const RigidTransform* motion);
  void matchByOverlap(const std::vector<SegmentedPlane>& planes);
  void matchByCoefficients(const std::vector<SegmentedPlane>& planes);
  void takeBestPairs();
  void keepLostTracks(double seconds);
  void addSeenTracks(const std::vector<SegmentedPlane>& planes, double seconds);
};

void PlaneTracker::Memory::move(const RigidTransform* motion) {
  for (PlaneTrack& track : tracks) {
    track.plane = -1;
    if (motion == nullptr) continue;
    track.normal = motion->linear() * track.normal;
    track.d -= track.normal.dot(motion->translation());
    track.centroid = *motion * track.centroid;
  }
  if (motion == nullptr) return;
  const Eigen::Isometry3f current_from_last = motion->cast<float>();
  for (PlaneSample& sample : samples) sample.point = current_from_last * sample.point;
}

void PlaneTracker::Memory::matchByOverlap(const std::vector<SegmentedPlane>& planes) {
  pairs.clear();
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const double weight = tracks[t].last_seen < last_image ? kLostWeight : 1.0;
    for (const SampleVotes* shared = votes.begin(t); shared != votes.end(t); ++shared) {
      const auto k = static_cast<std::size_t>(shared->plane);
      if (k >= tracked) continue;
      const double overlap =
          static_cast<double>(shared->samples) / (votes.inView(t) + seen_count[k] - shared->samples);
      if (overlap < kMinOverlap) continue;
      const double score = agreement(angleBetween(tracks[t].normal, planes[k].normal), max_angle,
                                     static_cast<double>(shared->distance) / shared->samples, max_distance);
      if (score > 0.0) pairs.push_back({weight * overlap * score, static_cast<int>(t), shared->plane});
    }
  }
  takeBestPairs();
}

void PlaneTracker::Memory::matchByCoefficients(const std::vector<SegmentedPlane>& planes) {
  pairs.clear();
  for (std::size_t k = 0; k < tracked; ++k) {
    if (track_of[k] >= 0) continue;
    const SegmentedPlane& plane = planes[k];
    const double reach = kReach * std::sqrt(plane.area);
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      const PlaneTrack& track = tracks[t];
      const double apart = (track.centroid - plane.centroid).norm();
      if (track.plane >= 0 || apart > reach) continue;
      const double distance = std::max(std::abs(track.normal.dot(plane.centroid) + track.d),
                                       std::abs(plane.normal.dot(track.centroid) + plane.d));
      const double score = agreement(angleBetween(track.normal, plane.normal), kStrictness * max_angle,
                                     distance / plane.centroid.norm(), kStrictness * max_distance);
      if (score > 0.0)
        pairs.push_back({score / (1.0 + apart / reach), static_cast<int>(t), static_cast<int>(k)});
    }
  }
  takeBestPairs();
}

void PlaneTracker::Memory::takeBestPairs() {
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    if (a.score != b.score) return a.score > b.score;
    return a.track != b.track ? a.track < b.track : a.plane < b.plane;
  });
  for (const Pair& pair : pairs) {
    PlaneTrack& track = tracks[pair.track];
    int& track_of_plane = track_of[pair.plane];
    if (track.plane >= 0 || track_of_plane >= 0) continue;
    track.plane = pair.plane;
    track_of_plane = pair.track;
  }
}

void PlaneTracker::Memory::keepLostTracks(double seconds) {
  next_index.assign(tracks.size(), -1);
  // From the newest to the oldest, to see which are too many; then in their order.
  std::size_t lost = 0, lost_samples = 0;
  for (std::size_t t = tracks.size(); t-- > 0;) {
    const PlaneTrack& track = tracks[t];
    if (track.plane >= 0 || seconds - track.last_seen > memory) continue;
    lost_samples += track.samples;
    if (++lost > kMaxLostTracks || lost_samples > kMaxLostSamples) break;
    next_index[t] = 0;
  }
  next_tracks.clear();
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (next_index[t] < 0) continue;
    next_index[t] = static_cast<int>(next_tracks.size());
    next_tracks.push_back(tracks[t]);
  }
  next_samples.clear();
  for (const PlaneSample& sample : samples) {
    const int index = next_index[sample.owner];
    if (index >= 0) next_samples.push_back({sample.point, index});
  }
}

void PlaneTracker::Memory::addSeenTracks(const std::vector<SegmentedPlane>& planes, double seconds) {
  const std::size_t first = next_tracks.size();
  for (std::size_t k = 0; k < tracked; ++k) {
    const SegmentedPlane& plane = planes[k];
    const bool is_new = track_of[k] < 0;
    const PlaneTrack* known = is_new ? nullptr : &tracks[track_of[k]];
    const std::uint32_t id = is_new ? ++last_id : known->id;
    next_tracks.push_back({id, is_new ? id : known->surface, seconds, plane.normal, plane.d, plane.centroid,
                           plane.inliers, static_cast<std::size_t>(seen_count[k]), -1});
  }
  for (const PlaneSample& sample : seen) {
    if (static_cast<std::size_t>(sample.owner) >= tracked) continue;
    next_samples.push_back({sample.point, static_cast<int>(first) + sample.owner});
  }
  passIdsOn(first, next_tracks);
  ids.clear();
  for (std::size_t t = first; t < next_tracks.size(); ++t) ids.push_back(next_tracks[t].id);
  for (std::size_t k = tracked; k < planes.size(); ++k) ids.push_back(kFirstUntrackedId + planes[k].label);
}

PlaneTracker::PlaneTracker(const TrackingParameters& parameters) : memory_(std::make_unique<Memory>()) {
  setParameters(parameters);
}
PlaneTracker::~PlaneTracker() = default;
PlaneTracker::PlaneTracker(PlaneTracker&&) noexcept = default;
PlaneTracker& PlaneTracker::operator=(PlaneTracker&&) noexcept = default;

void PlaneTracker::setParameters(const TrackingParameters& parameters) {
  memory_->tracking = parameters.track_planes;
  memory_->memory = parameters.track_memory;
  memory_->max_angle = parameters.track_angle * 3.14159265358979323846 / 180.0;
  memory_->max_distance = parameters.track_distance;
}

const std::vector<std::uint32_t>& PlaneTracker::track(const Segmentation& segmentation,
                                                      const CameraIntrinsics& camera, double seconds,
                                                      const RigidTransform* motion) {
  Memory& m = *memory_;
  if (!m.tracking) {
    reset();
    m.ids.clear();
    for (const SegmentedPlane& plane : segmentation.planes) m.ids.push_back(plane.label);
    m.tracked = m.ids.size();
    return m.ids;
  }
  m.move(motion);
  m.tracked = std::min(segmentation.planes.size(), kMaxTrackedPlanes);
  m.track_of.assign(m.tracked, -1);
  samplePlanes(segmentation, camera, m.seen, m.seen_count);
  m.votes.count(m.samples, m.tracks.size(), segmentation, camera);
  m.matchByOverlap(segmentation.planes);
  m.matchByCoefficients(segmentation.planes);
  joinParts(segmentation.planes, m.track_of, m.votes, m.tracks);
  m.keepLostTracks(seconds);
  m.addSeenTracks(segmentation.planes, seconds);
  m.tracks.swap(m.next_tracks);
  m.samples.swap(m.next_samples);
  m.last_image = seconds;
  return m.ids;
}

std::size_t PlaneTracker::untracked() const { return memory_->ids.size() - memory_->tracked; }

void PlaneTracker::reset() {
  memory_->tracks.clear();
  memory_->samples.clear();
  memory_->last_id = 0;
}

}  // namespace line_plane_segmentation
