// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/plane_extraction.h"

#include <algorithm>
#include <limits>

#include "line_plane_segmentation/candidate_detection.h"
#include "row_kernels.h"
#include "run_components.h"
#include "tile_grid.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxPlanes = std::numeric_limits<std::uint16_t>::max() - 1;  // 65535 is kept free: "do not judge"

// A candidate in the queue. Its inliers are at most `bound`; they are exactly so many once counted in this round.
struct Entry {
  int bound;
  int candidate;
  int bounded_in_round;
  int counted_in_round;
};

bool goesLater(const Entry& a, const Entry& b) {
  return a.bound != b.bound ? a.bound < b.bound : a.candidate > b.candidate;
}

}  // namespace

struct PlaneExtractor::Scratch {
  DepthImage remaining;             // depth of the pixels that no plane has taken yet
  std::vector<std::uint8_t> links;  // neighbours nearer than neighbor_distance
  std::vector<std::uint8_t> mask;
  TileGrid tiles;
  RunComponents components;
  std::vector<Entry> queue;

  void linkAll(const ViewRays& rays, float neighbor_distance) {
    const int width = remaining.width, height = remaining.height;
    links.resize(remaining.z.size());
    for (int v = 0; v < height; ++v) {
      const bool has_next = v + 1 < height;
      linkNeighbors(remaining.row(v), has_next ? remaining.row(v + 1) : nullptr, rays.x.data(),
                    rays.y[static_cast<std::size_t>(v)], has_next ? rays.y[static_cast<std::size_t>(v + 1)] : 0.0F,
                    width, neighbor_distance * neighbor_distance, links.data() + remaining.index(0, v));
    }
  }

  int validPixels(const PixelWindow& window) const {
    int count = 0;
    for (int v = window.first_v; v < window.last_v; ++v) {
      const float* z = remaining.row(v);
      count += static_cast<int>(std::count_if(z + window.first_u, z + window.last_u, [](float d) { return d > 0.0F; }));
    }
    return count;
  }

  int bound(const PlaneCandidate& candidate, const ViewRays& rays, float plane_distance) {
    return tiles.boundInliers(rays, candidate.normal.cast<float>(), static_cast<float>(candidate.d), plane_distance,
                              candidate.u, candidate.v);
  }

  void addRuns(int v, int first, int last) {
    const std::uint8_t* row_links = links.data() + remaining.index(0, v);
    const std::uint8_t* links_above = v > 0 ? row_links - remaining.width : nullptr;
    for (int u = first; u < last;) {
      if (mask[static_cast<std::size_t>(u)] == 0) {
        ++u;
        continue;
      }
      PixelRun run{v, u, u + 1};
      while (run.last < last && mask[static_cast<std::size_t>(run.last)] != 0 &&
             (row_links[run.last - 1] & kLinkRight) != 0) {
        ++run.last;
      }
      components.add(run, links_above);
      u = run.last;
    }
  }

  // The component of the candidate's inliers, or -1 if its own pixel is none. The tiles must be those of its bound.
  int grow(const PlaneCandidate& candidate, const ViewRays& rays, float plane_distance) {
    const Eigen::Vector3f normal = candidate.normal.cast<float>();
    const float d = static_cast<float>(candidate.d);
    components.clear();
    const std::vector<TileGrid::Span>& spans = tiles.spans();
    for (std::size_t begin = 0, end = 0; begin < spans.size(); begin = end) {
      const int tile_row = spans[begin].tile_row;
      while (end < spans.size() && spans[end].tile_row == tile_row) ++end;
      const int last_row = std::min((tile_row + 1) * TileGrid::kSide, remaining.height);
      for (int v = tile_row * TileGrid::kSide; v < last_row; ++v) {
        const float a = normal.y() * rays.y[static_cast<std::size_t>(v)] + normal.z();
        for (std::size_t s = begin; s < end; ++s) {
          const int first = spans[s].first, last = spans[s].last;
          markInliers(remaining.row(v) + first, rays.x.data() + first, last - first, a, normal.x(), d, plane_distance,
                      mask.data() + first);
          addRuns(v, first, last);
        }
      }
    }
    return components.componentAt(candidate.u, candidate.v);
  }

  void take(int component, std::uint16_t label, std::vector<std::uint16_t>& labels) {
    for (const PixelRun& run : components.runsOf(component)) {
      for (int u = run.first; u < run.last; ++u) tiles.remove(u, run.row, 1);
      const std::size_t first = remaining.index(run.first, run.row), last = remaining.index(run.last, run.row);
      std::fill(remaining.z.begin() + static_cast<std::ptrdiff_t>(first),
                remaining.z.begin() + static_cast<std::ptrdiff_t>(last), 0.0F);
      std::fill(labels.begin() + static_cast<std::ptrdiff_t>(first), labels.begin() + static_cast<std::ptrdiff_t>(last),
                label);
    }
  }
};

PlaneExtractor::PlaneExtractor() : scratch_(std::make_unique<Scratch>()) {}
PlaneExtractor::~PlaneExtractor() = default;

int PlaneExtractor::extract(const DepthImage& depth, const ViewRays& rays,
                            const std::vector<PlaneCandidate>& candidates, const Parameters& parameters,
                            std::vector<std::uint16_t>& labels) {
  if (candidates.empty()) return 0;
  Scratch& s = *scratch_;
  s.remaining = depth;
  s.mask.resize(static_cast<std::size_t>(depth.width));
  s.linkAll(rays, static_cast<float>(parameters.extraction.neighbor_distance));
  s.tiles.build(depth);

  const float plane_distance = static_cast<float>(parameters.extraction.plane_distance);
  const int min_inliers = parameters.extraction.min_plane_inliers;
  std::vector<Entry>& queue = s.queue;
  queue.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    queue.push_back({std::numeric_limits<int>::max(), static_cast<int>(i), -1, -1});
  }
  std::make_heap(queue.begin(), queue.end(), goesLater);

  int round = 0;
  while (!queue.empty() && round < kMaxPlanes) {
    std::pop_heap(queue.begin(), queue.end(), goesLater);
    Entry entry = queue.back();
    queue.pop_back();
    const PlaneCandidate& candidate = candidates[static_cast<std::size_t>(entry.candidate)];

    if (entry.counted_in_round == round) {  // the most of all: nobody's bound is higher
      s.bound(candidate, rays, plane_distance);
      const int component = s.grow(candidate, rays, plane_distance);
      s.take(component, static_cast<std::uint16_t>(++round), labels);
      continue;
    }
    if (entry.bounded_in_round != round) {
      const PixelWindow window = windowAround(candidate.u, candidate.v, parameters.candidates.normal_window,
                                              depth.width, depth.height);
      if (s.validPixels(window) < parameters.candidates.min_window_points) continue;
      entry.bound = std::min(entry.bound, s.bound(candidate, rays, plane_distance));
      entry.bounded_in_round = round;
    } else {
      s.bound(candidate, rays, plane_distance);
      const int component = s.grow(candidate, rays, plane_distance);
      entry.bound = component < 0 ? 0 : s.components.pixelCount(component);
      entry.counted_in_round = round;
    }
    if (entry.bound < min_inliers) continue;
    queue.push_back(entry);
    std::push_heap(queue.begin(), queue.end(), goesLater);
  }
  return round;
}

}  // namespace line_plane_segmentation
