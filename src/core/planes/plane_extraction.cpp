// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_extraction.h"

#include <algorithm>
#include <limits>

#include "kernels/row_kernels.h"
#include "planes/candidate_detection.h"
#include "planes/run_components.h"
#include "planes/tile_grid.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxPlanes =
    std::numeric_limits<std::uint16_t>::max() - 1;  // 65535 is kept free: "do not judge"

// How a candidate's bound was found: each step costs more than the one before, and bounds tighter.
enum class Bound { kStale, kTiles, kUnconnected, kExact };

// A candidate in the queue. In `round` its inliers were at most `bound`, and they only fall.
struct Entry {
  int bound;
  int candidate;
  int round;
  Bound kind;
};

bool goesLater(const Entry& a, const Entry& b) {
  return a.bound != b.bound ? a.bound < b.bound : a.candidate > b.candidate;
}

}  // namespace

struct PlaneExtractor::Scratch {
  DepthImage remaining;                   // depth of the pixels that no plane has taken yet
  std::vector<std::uint8_t> links;        // neighbours nearer than neighbor_distance
  std::vector<std::uint8_t> mask;         // of one row
  std::vector<std::uint64_t> boundaries;  // of one row: a byte for each pixel and one more
  TileGrid tiles;
  RunComponents components;
  std::vector<int> linked_component;  // component per candidate, -1 if its pixel is invalid
  std::vector<int> linked_pixels;     // of that component, those that no plane has taken
  std::vector<Entry> queue;

  void start(const DepthImage& depth, const ViewRays& rays, const std::vector<PlaneCandidate>& candidates,
             double neighbor_distance);
  void tighten(Entry& entry, const PlaneCandidate& candidate, const ViewRays& rays, float plane_distance);

  void linkAll(const ViewRays& rays, float neighbor_distance) {
    const int width = remaining.width, height = remaining.height;
    links.resize(remaining.z.size());
    for (int v = 0; v < height; ++v) {
      const bool has_next = v + 1 < height;
      linkNeighbors(remaining.row(v), has_next ? remaining.row(v + 1) : nullptr, rays.x.data(), rays.y[v],
                    has_next ? rays.y[v + 1] : 0.0F, width, neighbor_distance * neighbor_distance,
                    links.data() + remaining.index(0, v));
    }
  }

  int validPixels(const PixelWindow& window) const {
    int count = 0;
    for (int v = window.first_v; v < window.last_v; ++v) {
      const float* z = remaining.row(v);
      count += static_cast<int>(
          std::count_if(z + window.first_u, z + window.last_u, [](float d) { return d > 0.0F; }));
    }
    return count;
  }

  int bound(const PlaneCandidate& candidate, const ViewRays& rays, float plane_distance) {
    return tiles.boundInliers(rays, candidate.normal.cast<float>(), static_cast<float>(candidate.d),
                              plane_distance, candidate.u, candidate.v);
  }

  // Calls `visit(row, span)` for the stretches of pixels that the last bound() has left, from the top.
  template <typename Visitor>
  void forEachSpan(Visitor&& visit) {
    const std::vector<TileGrid::Span>& spans = tiles.spans();
    for (std::size_t begin = 0, end = 0; begin < spans.size(); begin = end) {
      const int tile_row = spans[begin].tile_row;
      while (end < spans.size() && spans[end].tile_row == tile_row) ++end;
      const int last_row = std::min((tile_row + 1) * TileGrid::kSide, remaining.height);
      for (int v = tile_row * TileGrid::kSide; v < last_row; ++v) {
        for (std::size_t s = begin; s < end; ++s) visit(v, spans[s]);
      }
    }
  }

  // Inliers, whether they hang together with the candidate or not.
  int countUnconnected(const PlaneCandidate& candidate, const ViewRays& rays, float plane_distance) {
    const Eigen::Vector3f normal = candidate.normal.cast<float>();
    int count = 0;
    forEachSpan([&](int v, const TileGrid::Span& span) {
      const float a = normal.y() * rays.y[v] + normal.z();
      count += countInliers(remaining.row(v) + span.first, rays.x.data() + span.first, span.last - span.first,
                            a, normal.x(), static_cast<float>(candidate.d), plane_distance);
    });
    return count;
  }

  // Adds the runs of the marked pixels of columns first to last - 1.
  void addRuns(int v, int first, int last) {
    const std::uint8_t* row_links = links.data() + remaining.index(0, v);
    const std::uint8_t* links_above = v > 0 ? row_links - remaining.width : nullptr;
    const int count = last - first;
    std::uint8_t* begins = reinterpret_cast<std::uint8_t*>(boundaries.data());
    markRunBoundaries(mask.data() + first, row_links + first, count, begins);
    begins[count] = mask[last - 1];  // what is open at the end ends there
    std::fill(begins + count + 1, begins + (count / 8 + 1) * 8, std::uint8_t{0});
    int open = -1;
    for (int word = 0; word <= count / 8; ++word) {
      if (boundaries[word] == 0) continue;
      for (int i = word * 8; i < word * 8 + 8; ++i) {
        if (begins[i] == 0) continue;
        if (open >= 0) components.add({v, first + open, first + i}, links_above);
        open = i < count && mask[first + i] != 0 ? i : -1;
      }
    }
  }

  // The pixels of a plane are connected by links, so the size of its candidate's component of linked pixels
  // is an upper bound of their number.
  void countLinked(const std::vector<PlaneCandidate>& candidates) {
    components.clear();
    for (int v = 0; v < remaining.height; ++v) {
      const float* z = remaining.row(v);
      for (int u = 0; u < remaining.width; ++u) mask[u] = z[u] > 0.0F ? 1 : 0;
      addRuns(v, 0, remaining.width);
    }
    linked_component.clear();
    linked_pixels.clear();
    for (const PlaneCandidate& candidate : candidates) {
      const int component = components.componentAt(candidate.u, candidate.v);
      linked_component.push_back(component);
      linked_pixels.push_back(component < 0 ? 0 : components.pixelCount(component));
    }
  }

  // The component of the candidate's inliers, or -1 if its own pixel is none. The tiles must be those of its
  // bound.
  int grow(const PlaneCandidate& candidate, const ViewRays& rays, float plane_distance) {
    const Eigen::Vector3f normal = candidate.normal.cast<float>();
    const float d = static_cast<float>(candidate.d);
    components.clear();
    forEachSpan([&](int v, const TileGrid::Span& span) {
      const float a = normal.y() * rays.y[v] + normal.z();
      markInliers(remaining.row(v) + span.first, rays.x.data() + span.first, span.last - span.first, a,
                  normal.x(), d, plane_distance, mask.data() + span.first);
      addRuns(v, span.first, span.last);
    });
    return components.componentAt(candidate.u, candidate.v);
  }

  void take(int candidate, int component, std::uint16_t label, std::vector<std::uint16_t>& labels) {
    for (std::size_t i = 0; i < linked_pixels.size(); ++i) {
      if (linked_component[i] == linked_component[candidate])
        linked_pixels[i] -= components.pixelCount(component);
    }
    for (const PixelRun& run : components.runsOf(component)) {
      for (int u = run.first; u < run.last; ++u) tiles.remove(u, run.row, 1);
      const std::size_t first = remaining.index(run.first, run.row),
                        last = remaining.index(run.last, run.row);
      std::fill(remaining.z.begin() + static_cast<std::ptrdiff_t>(first),
                remaining.z.begin() + static_cast<std::ptrdiff_t>(last), 0.0F);
      std::fill(labels.begin() + static_cast<std::ptrdiff_t>(first),
                labels.begin() + static_cast<std::ptrdiff_t>(last), label);
    }
  }
};

PlaneExtractor::PlaneExtractor() : scratch_(std::make_unique<Scratch>()) {}
PlaneExtractor::~PlaneExtractor() = default;

void PlaneExtractor::Scratch::start(const DepthImage& depth, const ViewRays& rays,
                                    const std::vector<PlaneCandidate>& candidates, double neighbor_distance) {
  remaining = depth;
  mask.resize(static_cast<std::size_t>(depth.width));
  boundaries.resize(static_cast<std::size_t>(depth.width) / 8 + 1);
  linkAll(rays, static_cast<float>(neighbor_distance));
  countLinked(candidates);
  tiles.build(depth);
  queue.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    queue.push_back({linked_pixels[i], static_cast<int>(i), 0, Bound::kStale});
  }
  std::make_heap(queue.begin(), queue.end(), goesLater);
}

// Lowers the bound of an entry by the next step.
void PlaneExtractor::Scratch::tighten(Entry& entry, const PlaneCandidate& candidate, const ViewRays& rays,
                                      float plane_distance) {
  const int tile_bound = bound(candidate, rays, plane_distance);
  switch (entry.kind) {
    case Bound::kStale:
      entry.bound = std::min({entry.bound, tile_bound, linked_pixels[entry.candidate]});
      entry.kind = Bound::kTiles;
      break;
    case Bound::kTiles:
      entry.bound = std::min(entry.bound, countUnconnected(candidate, rays, plane_distance));
      entry.kind = Bound::kUnconnected;
      break;
    case Bound::kUnconnected:
    case Bound::kExact: {
      const int component = grow(candidate, rays, plane_distance);
      entry.bound = component < 0 ? 0 : components.pixelCount(component);
      entry.kind = Bound::kExact;
      break;
    }
  }
}

int PlaneExtractor::extract(const DepthImage& depth, const ViewRays& rays,
                            const std::vector<PlaneCandidate>& candidates, const Parameters& parameters,
                            std::vector<std::uint16_t>& labels, StageObserver* observer) {
  if (candidates.empty()) return 0;
  Scratch& s = *scratch_;
  s.start(depth, rays, candidates, parameters.extraction.neighbor_distance);
  const float plane_distance = static_cast<float>(parameters.extraction.plane_distance);
  int round = 0;
  while (!s.queue.empty() && round < kMaxPlanes) {
    if (observer != nullptr && observer->isStopRequested()) break;
    std::pop_heap(s.queue.begin(), s.queue.end(), goesLater);
    Entry entry = s.queue.back();
    s.queue.pop_back();
    const PlaneCandidate& candidate = candidates[entry.candidate];

    if (entry.round != round) entry.kind = Bound::kStale;
    entry.round = round;
    if (entry.kind == Bound::kStale) {
      const PixelWindow window = windowAround(candidate.u, candidate.v, parameters.candidates.normal_window,
                                              depth.width, depth.height);
      if (s.validPixels(window) < parameters.candidates.min_window_points) continue;
    }
    if (entry.kind == Bound::kExact) {  // the most of all: nobody's bound is higher
      s.bound(candidate, rays, plane_distance);
      s.take(entry.candidate, s.grow(candidate, rays, plane_distance), static_cast<std::uint16_t>(++round),
             labels);
      continue;
    }
    s.tighten(entry, candidate, rays, plane_distance);
    if (entry.bound < parameters.extraction.min_plane_inliers) continue;
    s.queue.push_back(entry);
    std::push_heap(s.queue.begin(), s.queue.end(), goesLater);
  }
  return round;
}

}  // namespace line_plane_segmentation
