// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/patch_clustering.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr std::size_t kMaxClusters = 65534;  // labels are 16 bit, and 65535 is kept free: "do not judge"

// The sensor's own distortion bends a plane the more of the picture it fills: over so much of the grid, as
// much as max_curvedness allows a small one.
constexpr double kDistortedShare = 0.02;

// A patch whose pixels deviate from its cluster's plane by so many times what is usual there belongs to
// something else that runs into the plane; not so if that is within the tolerance anyway.
constexpr double kOutlierFactor = 2.7;
constexpr double kNeverOutlier = 0.5;  // in tolerances squared

// Fine patches first join the clusters that are there, if that costs no more than this: beside a plane they
// would else make a rim of their own. Only then are they asked whether they are like each other.
constexpr double kJoinCost = 0.5;  // of merge_cost

// So many times as many fine patches as coarse ones are found on narrow surfaces only.
constexpr double kNarrowFine = 1.5;

// A cluster is curved if a quadratic surface leaves less than so much of its deviations from the plane; less,
// if it fills so much of the picture that the sensor may bend it. One that fills even more is always a plane.
constexpr double kBentRest = 0.25, kBentRestOfLarge = 0.1;
constexpr double kLargeShare = 0.05, kNeverUnevenShare = 0.1;
constexpr int kMinBendPoints = 8;
constexpr double kBendUnit = 0.01;  // [1/px] keeps fourth powers near 1

// So few planar patches with no plane within so many tiles are clutter, as on people: closer scanlines on
// them would only make more of it.
constexpr int kMostClutter = 3, kClutterReach = 2;

// So many outliers of a plane are another one if they all lie the same step off it: the mean of the step is
// at least so many times its standard deviation. From a plane that is bent they rise steadily.
constexpr int kMinStepPatches = 12;
constexpr double kSteadyStep = 10.0;

// What a bound for small planes grows to for one that fills a share of the picture.
double allowDistortion(double bound, double share) { return bound * (1.0 + share / kDistortedShare); }

// Whether the pixels of so many patches, which fill a share of the picture, are enough of a plane and flat.
bool isPlane(const FittedPixels& pixels, int patches, double share, const ClusterParameters& parameters) {
  return patches >= parameters.min_patches &&
         pixels.squared_error <= allowDistortion(parameters.max_curvedness, share) * pixels.moments.pixels;
}

// Whether the patches of a cluster lie on another surface than a plane.
bool isUneven(const SurfaceBend& bend, double share, const ClusterParameters& parameters) {
  if (bend.points() < kMinBendPoints) return false;
  const SurfaceBend::Residuals rest = bend.fit();
  if (rest.plane > allowDistortion(parameters.max_waviness, share)) return true;
  const double bent_rest = share > kLargeShare ? kBentRestOfLarge : kBentRest;
  return rest.plane - rest.quadric > parameters.max_bend && rest.quadric < bent_rest * rest.plane;
}

// The mean deviation of a patch from a plane, in tolerances.
double deviationOf(const RegressionMoments& patch, const InverseDepthPlane& plane) {
  return (patch.w - plane.a * patch.x - plane.b * patch.y - plane.c * patch.one) /
         std::sqrt(patch.one * patch.pixels);
}

}  // namespace

bool PatchClusterer::Step::isSteady() const {
  const double mean = sum / patches, variance = squares / patches - mean * mean;
  return mean * mean > kSteadyStep * kSteadyStep * variance;
}

void PatchClusterer::clusterCoarse(const PatchGrid& coarse, const Parameters& parameters,
                                   std::vector<std::uint8_t>& explained) {
  forest_.clear();
  for (const SurfacePatch& patch : coarse.patches) forest_.add(patch, coarse.shareOfPicture());
  for (int r = 0; r < coarse.rows; ++r) {
    for (int c = 0; c < coarse.columns; ++c) {
      const int cell = coarse.indexOf(c, r), i = coarse.patchAt(cell);
      if (i < 0) continue;
      const int right = c + 1 < coarse.columns ? coarse.patchAt(cell + 1) : -1;
      const int below = r + 1 < coarse.rows ? coarse.patchAt(cell + coarse.columns) : -1;
      if (right >= 0) forest_.addPair(i, right);
      if (below >= 0) forest_.addPair(i, below);
    }
  }
  forest_.mergePairs(parameters.clusters.merge_cost,
                     {1.0 / 64, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 1.0});
  explained.assign(coarse.patch_at.size(), 0);
  for (int i = 0; i < forest_.size(); ++i) {
    const bool is_explained = isPlaneAt(forest_.find(i), parameters.clusters);
    explained[static_cast<std::size_t>(coarse.cells[static_cast<std::size_t>(i)])] = is_explained ? 1 : 0;
  }
  dismissClutter(coarse, explained);
}

bool PatchClusterer::isPlaneAt(int root, const ClusterParameters& parameters) const {
  return isPlane(forest_.fitOf(root), forest_.patchesOf(root), forest_.shareOf(root), parameters);
}

// Marks planar patches that no closer look makes a plane of.
void PatchClusterer::dismissClutter(const PatchGrid& coarse, std::vector<std::uint8_t>& explained) {
  in_plane_ = explained;
  const auto isNearPlane = [&](int column, int row) {
    const int first = std::max(0, column - kClutterReach);
    const int last = std::min(coarse.columns - 1, column + kClutterReach);
    for (int r = std::max(0, row - kClutterReach); r <= std::min(coarse.rows - 1, row + kClutterReach); ++r) {
      for (int c = first; c <= last; ++c) {
        if (in_plane_[static_cast<std::size_t>(coarse.indexOf(c, r))] != 0) return true;
      }
    }
    return false;
  };
  for (int i = 0; i < forest_.size(); ++i) {
    if (forest_.patchesOf(forest_.find(i)) > kMostClutter) continue;
    const int cell = coarse.cells[static_cast<std::size_t>(i)];
    if (!isNearPlane(cell % coarse.columns, cell / coarse.columns))
      explained[static_cast<std::size_t>(cell)] = 1;
  }
}

// First the fine patches join what is there, then each other. They need fewer rounds than the coarse ones:
// planes that are sure are there.
void PatchClusterer::addFine(const PatchLevels& levels, double limit) {
  const PatchGrid &coarse = levels.coarse, &fine = levels.fine;
  for (const SurfacePatch& patch : fine.patches) forest_.add(patch, fine.shareOfPicture());
  const int first = levels.firstFine();
  const double join_limit = kJoinCost * limit;
  for (int i = first; i < levels.count(); ++i) {
    const int cell = fine.cells[static_cast<std::size_t>(i - first)];
    const int c = cell % fine.columns, r = cell / fine.columns;
    const int column = levels.tileColumn(c), row = levels.tileRow(r);
    const auto ask = [&](int tile_column, int tile_row) {
      const int patch = coarse.patchAt(coarse.indexOf(tile_column, tile_row));
      if (patch >= 0) forest_.addPair(i, patch);
    };
    ask(column, row);
    for (const int other : {levels.tileColumn(c - 1), levels.tileColumn(c + 1)}) {
      if (other != column) ask(other, row);
    }
    for (const int other : {levels.tileRow(r - 1), levels.tileRow(r + 1)}) {
      if (other != row) ask(column, other);
    }
  }
  forest_.mergePairs(join_limit, {1.0 / 4, 1.0});
  for (int i = first; i < levels.count(); ++i) {
    const int cell = fine.cells[static_cast<std::size_t>(i - first)];
    const int left = cell % fine.columns == 0 ? -1 : fine.patchAt(cell - 1);
    const int above = fine.patchAt(cell - fine.columns);
    if (left >= 0) forest_.addPair(first + left, i);
    if (above >= 0) forest_.addPair(first + above, i);
  }
  forest_.mergePairs(limit, {1.0 / 16, 1.0 / 4, 1.0, 1.0});
}

// Takes outliers out of the clusters, whose planes they would bend. Where there are enough coarse patches,
// with their longer windows, they alone make the plane; on narrow surfaces these look beyond the borders.
void PatchClusterer::trim(const PatchLevels& levels, int min_patches, std::vector<PatchCluster>& clusters,
                          std::vector<int>& cluster_of) {
  coarse_sums_.assign(clusters.size(), PatchCluster{});
  fine_sums_.assign(clusters.size(), PatchCluster{});
  for (int i = 0; i < levels.count(); ++i) {
    int& cluster = cluster_of[static_cast<std::size_t>(i)];
    if (cluster < 0) continue;
    const std::size_t k = static_cast<std::size_t>(cluster);
    const RegressionMoments& patch = levels.patch(i).moments;
    const double usual = clusters[k].squared_error / clusters[k].moments.pixels;
    if (patch.squaredErrorTo(clusters[k].plane) >
        std::max(kOutlierFactor * usual, kNeverOutlier) * patch.pixels) {
      cluster = -1;
    } else {
      PatchCluster& sums = i < levels.firstFine() ? coarse_sums_[k] : fine_sums_[k];
      sums.moments += patch;
      ++sums.patches;
    }
  }
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    PatchCluster &trimmed = coarse_sums_[k], &fine = fine_sums_[k];
    trimmed.share = clusters[k].share;
    trimmed.is_narrow = trimmed.patches < min_patches || fine.patches > kNarrowFine * trimmed.patches;
    if (trimmed.is_narrow) {
      trimmed.moments += fine.moments;
      trimmed.patches += fine.patches;
    }
    trimmed.squared_error = trimmed.moments.fit(trimmed.plane);
    if (trimmed.squared_error >= 0.0) clusters[k] = trimmed;
  }
}

// A step within the tolerance does not keep a door from merging with the wall that it is set back in;
// trimming then leaves it in no plane. Coarse patches that are outliers of one plane, all the same step off
// it, make another one, wherever on it they are: two doors at one depth are one plane.
void PatchClusterer::partAtSteps(const PatchLevels& levels, const ClusterParameters& parameters,
                                 std::vector<PatchCluster>& clusters, std::vector<int>& cluster_of) {
  const std::size_t coarse = levels.coarse.patches.size(), planes = clusters.size();
  outliers_.assign(planes, PatchCluster{});
  outlier_of_.assign(cluster_of.size(), -1);
  int most = 0;
  for (std::size_t i = 0; i < coarse; ++i) {
    if (untrimmed_[i] < 0 || cluster_of[i] >= 0) continue;
    outlier_of_[i] = untrimmed_[i];
    PatchCluster& sums = outliers_[static_cast<std::size_t>(untrimmed_[i])];
    sums.moments += levels.coarse.patches[i].moments;
    most = std::max(most, ++sums.patches);
  }
  if (most < kMinStepPatches) return;
  for (PatchCluster& sums : outliers_) sums.squared_error = sums.moments.fit(sums.plane);
  // Others, elsewhere along the plane's border, are no part of it.
  for (int round = 0; round < 2; ++round) trim(levels, parameters.min_patches, outliers_, outlier_of_);

  steps_.assign(planes, Step{});
  for (std::size_t i = 0; i < coarse; ++i) {
    if (outlier_of_[i] < 0) continue;
    const std::size_t k = static_cast<std::size_t>(outlier_of_[i]);
    steps_[k].add(deviationOf(levels.coarse.patches[i].moments, clusters[k].plane));
  }
  new_index_.assign(planes, -1);
  for (std::size_t k = 0; k < planes && clusters.size() < kMaxClusters; ++k) {
    const double share = steps_[k].patches * levels.coarse.shareOfPicture();
    outliers_[k].share = share;
    if (steps_[k].patches < kMinStepPatches || !steps_[k].isSteady() ||
        !isPlane(outliers_[k], outliers_[k].patches, share, parameters))
      continue;
    new_index_[k] = static_cast<int>(clusters.size());
    clusters.push_back(outliers_[k]);
    // Windows that reach over the step would tilt it.
    clusters.back().is_narrow = true;
    clusters[k].share -= share;
  }
  for (std::size_t i = 0; i < coarse; ++i) {
    if (outlier_of_[i] >= 0) cluster_of[i] = new_index_[static_cast<std::size_t>(outlier_of_[i])];
  }
}

// Takes away the clusters that are no planes but curved, as people and cushions are, or uneven. A cluster's
// mean squared error hides that behind its pixels' noise; the patches, each a mean over many pixels, show it.
void PatchClusterer::dropUneven(const PatchLevels& levels, const ClusterParameters& parameters,
                                std::vector<PatchCluster>& clusters, std::vector<int>& cluster_of) {
  bends_.assign(clusters.size(), SurfaceBend{});
  for (int i = 0; i < levels.count(); ++i) {
    const int cluster = cluster_of[static_cast<std::size_t>(i)];
    if (cluster < 0) continue;
    const std::size_t k = static_cast<std::size_t>(cluster);
    if (clusters[k].share > kNeverUnevenShare) continue;
    bends_[k].add(kBendUnit * levels.patch(i).u, kBendUnit * levels.patch(i).v,
                  deviationOf(levels.patch(i).moments, clusters[k].plane));
  }
  new_index_.assign(clusters.size(), -1);
  int kept = 0;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    if (isUneven(bends_[k], clusters[k].share, parameters)) continue;
    new_index_[k] = kept;
    clusters[static_cast<std::size_t>(kept++)] = clusters[k];
  }
  if (static_cast<std::size_t>(kept) == clusters.size()) return;
  clusters.resize(static_cast<std::size_t>(kept));
  for (int& k : cluster_of) k = k < 0 ? -1 : new_index_[static_cast<std::size_t>(k)];
}

void PatchClusterer::cluster(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
                             const Parameters& parameters, std::vector<PatchCluster>& clusters,
                             std::vector<int>& cluster_of) {
  addFine(levels, parameters.clusters.merge_cost);
  coplanar_merger_.merge(depth, rays, levels, parameters, forest_);

  clusters.clear();
  cluster_of.assign(static_cast<std::size_t>(forest_.size()), -1);
  for (int i = 0; i < forest_.size() && clusters.size() < kMaxClusters; ++i) {
    if (forest_.find(i) != i || !isPlaneAt(i, parameters.clusters)) continue;
    cluster_of[static_cast<std::size_t>(i)] = static_cast<int>(clusters.size());
    clusters.push_back(forest_.cluster(i));
  }
  for (int i = 0; i < forest_.size(); ++i) {
    cluster_of[static_cast<std::size_t>(i)] = cluster_of[static_cast<std::size_t>(forest_.find(i))];
  }
  untrimmed_ = cluster_of;
  trim(levels, parameters.clusters.min_patches, clusters, cluster_of);
  partAtSteps(levels, parameters.clusters, clusters, cluster_of);
  dropUneven(levels, parameters.clusters, clusters, cluster_of);
}

}  // namespace line_plane_segmentation
