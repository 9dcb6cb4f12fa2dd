// SPDX-License-Identifier: BSD-3-Clause
#include "lines/line_growing.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

// Noise's part of the bound of the added squared error of two neighbours, in tolerances squared: the 99 %
// quantile of chi-squared with two degrees of freedom (9.2) times the number of pixels that share their error
// (kSharedErrors), which makes 110 sigma_z² or 43 tolerances²; halved, since a missing join costs nothing
// where a crossing scanline connects both pieces. The other part is the sensor's distortion: one tolerance
// squared per pixel of the smaller piece.
constexpr double kNoiseError = 20.0;

constexpr double kMostAlike = 1.0 / 8;  // fraction of that bound for the first merges

constexpr int kMaxHole = 3;  // [windows] a segment continues after a hole one window shorter

// Whether a window that no neighbour continues has depths of two surfaces. Its line is then steep, and the
// tolerance along the ray would grow with that: it is that of a surface that faces the camera.
bool isEdge(const LineSums& window, double squared_error, double max_flatness,
            const DepthTolerance& tolerance) {
  const double rho = window.rho / window.n;
  return squared_error > max_flatness * tolerance.squaredAt(rho, rho * rho) * window.n;
}

}  // namespace

// The segments that the first merges made of the windows of a scanline.
void LineGrower::collect(int lane, int windows) {
  count_ = 0;
  const auto end = [this, lane](int window) {
    const GrowingSegments& grown = grown_[window];
    const auto at = [lane](const ScanlineLanes& lanes) { return lanes[lane]; };
    Node& node = nodes_[count_ - 1];
    node.last = static_cast<int>(at(grown.last));
    node.sums = {at(grown.n), at(grown.t), at(grown.tt), at(grown.rho), at(grown.t_rho), at(grown.rho_rho)};
    node.squared_error = at(grown.squared_error);
    node.tolerance2 = at(grown.tolerance2);
  };
  for (std::size_t word = 0; word < starts_.size(); ++word) {
    for (std::uint64_t bits = starts_[word][lane]; bits != 0; bits &= bits - 1) {
      const int start = static_cast<int>(64 * word) + __builtin_ctzll(bits);
      if (count_ > 0) end(start - 1);
      nodes_[count_++].first = start;
    }
  }
  if (count_ > 0) end(windows - 1);
}

// Merges a segment with the one before it if that adds less than the bound.
bool LineGrower::mergeIfAlike(Node& before, const Node& node) {
  if (node.first - before.last > kMaxHole) return false;
  const LineSums sums = before.sums + node.sums;
  const InverseDepthLine line = fitInverseDepthLine(sums);
  const double bound =
      (kNoiseError + std::min(before.sums.n, node.sums.n)) * std::min(before.tolerance2, node.tolerance2);
  if (!(line.squared_error - before.squared_error - node.squared_error < bound)) return false;
  before.tolerance2 = (before.tolerance2 * before.sums.n + node.tolerance2 * node.sums.n) * line.inv_n;
  before.last = node.last;
  before.sums = sums;
  before.squared_error = line.squared_error;
  return true;
}

// Merges neighbours within the bound, from the start of the scanline.
void LineGrower::mergeNeighbors() {
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    if (kept > 0 && mergeIfAlike(nodes_[kept - 1], nodes_[i])) continue;
    if (kept != i) nodes_[kept] = nodes_[i];
    ++kept;
  }
  count_ = kept;
}

// Of as many scanlines as are merged at a time, from one on. Behind the last one it is repeated.
void LineGrower::mergeMostAlike(const std::vector<float>& orthogonal_ray, const ScanlineSet& set, int first,
                                const MergeRule& rule) {
  std::array<const LineSums*, kMergedScanlines> sums;
  ScanlineLanes inv_k2;
  for (int lane = 0; lane < kMergedScanlines; ++lane) {
    const int scanline = std::min(first + lane, set.count() - 1);
    // The plane through a line that comes nearest to the camera is as far away as the line is in its scan.
    const double ray = orthogonal_ray[set.pixels[scanline]];
    inv_k2[lane] = 1.0 / (1.0 + ray * ray);
    sums[lane] = set.sums.data() + set.indexOf(scanline, 0);
  }
  mergeWindows(sums, inv_k2, set.windows, rule, grown_.data(), starts_.data());
}

void LineGrower::grow(const std::vector<float>& orthogonal_ray, const Parameters& parameters,
                      ScanlineSet& set) {
  set.segments.clear();
  set.segment_of.assign(set.sums.size(), -1);
  if (set.count() == 0) return;
  nodes_.resize(static_cast<std::size_t>(set.windows));
  grown_.resize(static_cast<std::size_t>(set.windows));
  starts_.resize((static_cast<std::size_t>(set.windows) + 63) / 64);
  const DepthTolerance tolerance{parameters.noise, parameters.patches.patch_noise_factor,
                                 parameters.patches.patch_distance};
  const MergeRule rule{kNoiseError, kMostAlike, kMaxHole, tolerance};
  for (int k = 0; k < set.count(); ++k) {
    // What is most alike grows together before anything doubtful is compared.
    const int lane = k % kMergedScanlines;
    if (lane == 0) mergeMostAlike(orthogonal_ray, set, k, rule);
    collect(lane, set.windows);
    mergeNeighbors();
    for (int i = 0; i < count_; ++i) {
      const Node& node = nodes_[i];
      if (node.sums.n < parameters.lines.min_line_points) continue;
      if (node.first == node.last &&
          isEdge(node.sums, node.squared_error, parameters.patches.patch_flatness, tolerance))
        continue;
      const auto at = set.segment_of.begin() + static_cast<std::ptrdiff_t>(set.indexOf(k, 0));
      std::fill(at + node.first, at + node.last + 1, static_cast<int>(set.segments.size()));
      set.segments.push_back({k, node.first, node.last, node.sums, node.squared_error, node.tolerance2});
    }
  }
}

// Collects the squared distances of pieces that are `windows` windows long.
void NoiseMeter::collect(const ScanlineSet& set, const NoiseParameters& noise, int windows) {
  constexpr double kMinFilled = 0.7;
  struct Piece {
    double t = 0.0, rho = 0.0;  // means
    bool is_filled = false;
  };
  const double min_pixels = kMinFilled * windows * set.window;
  const auto pieceAt = [windows, min_pixels](const LineSums* sums) {
    double n = 0.0, t = 0.0, rho = 0.0;
    for (int i = 0; i < windows; ++i) n += sums[i].n, t += sums[i].t, rho += sums[i].rho;
    const double inv_n = 1.0 / n;
    return Piece{t * inv_n, rho * inv_n, n >= min_pixels};
  };
  const DepthTolerance sigma{noise, 1.0};
  for (int k = 0; k < set.count(); k += 2) {
    const LineSums* sums = set.sums.data() + set.indexOf(k, 0);
    Piece a, b;
    for (int i = 0; i + windows <= set.windows; i += windows) {
      const Piece c = pieceAt(sums + i);
      if (a.is_filled && b.is_filled && c.is_filled) {
        const double between = (b.t - a.t) / (c.t - a.t);
        const double error = b.rho - a.rho - between * (c.rho - a.rho), expected = sigma.along(b.rho);
        deviations_.push_back(static_cast<float>(error * error / (expected * expected)));
      }
      a = b;
      b = c;
    }
  }
}

// @param chi_squared  the quantile of chi-squared with one degree of freedom
double NoiseMeter::ratioOver(const ScanlineSet& rows, const ScanlineSet& columns,
                             const NoiseParameters& noise, int windows, double quantile, double chi_squared) {
  constexpr std::size_t kFewest = 20;
  deviations_.clear();
  collect(rows, noise, windows);
  collect(columns, noise, windows);
  if (deviations_.size() < kFewest) return 1.0;
  const auto at =
      deviations_.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(deviations_.size()));
  std::nth_element(deviations_.begin(), at, deviations_.end());
  return std::sqrt(static_cast<double>(*at) / chi_squared);
}

double NoiseMeter::ratio(const ScanlineSet& rows, const ScanlineSet& columns, const NoiseParameters& noise) {
  constexpr int kWindows = 2;  // longer than the noise is correlated, short enough for most surfaces
  return ratioOver(rows, columns, noise, kWindows, 0.5, 0.455);
}

double NoiseMeter::distortionRatio(const ScanlineSet& rows, const ScanlineSet& columns,
                                   const NoiseParameters& noise, double length) {
  const int windows = std::max(2, static_cast<int>(std::lround(length / std::max(1, rows.window))));
  return ratioOver(rows, columns, noise, windows, 0.25, 0.1015);
}

}  // namespace line_plane_segmentation
