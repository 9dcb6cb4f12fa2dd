// SPDX-License-Identifier: BSD-3-Clause
#include "hoover.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace line_plane_segmentation {
namespace {

enum class Kind { kCorrect, kOverSegmented, kUnderSegmented };

// One way to explain some regions of both images by each other.
struct Instance {
  Kind kind = Kind::kCorrect;
  std::vector<std::size_t> truth;
  std::vector<std::size_t> labels;
  double average = 0.0;  // of the fractions that its definition compares with the tolerance
};

struct Fractions {
  std::size_t truth = 0;
  std::size_t label = 0;
  double of_truth = 0.0;
  double of_label = 0.0;
};

// Tolerates rounding: 80 of 100 pixels count as a fraction of 0.8.
bool reaches(double fraction, double tolerance) { return fraction + 1e-9 >= tolerance; }

std::vector<Fractions> fractionsOf(const RegionOverlaps& regions) {
  std::vector<Fractions> fractions;
  for (const Overlap& overlap : regions.overlaps) {
    const auto pixels = static_cast<double>(overlap.pixels);
    fractions.push_back({overlap.truth, overlap.label,
                         pixels / static_cast<double>(regions.truth[overlap.truth].pixels),
                         pixels / static_cast<double>(regions.labels[overlap.label].pixels)});
  }
  return fractions;
}

bool isMutual(const Fractions& pair, double tolerance) {
  return reaches(pair.of_truth, tolerance) && reaches(pair.of_label, tolerance);
}

// The over-segmented truth regions, or, with the two images exchanged, the under-segmenting label regions:
// `whole` is the region in pieces, `piece` one of them, each given by its index and its covered fraction.
template <typename Whole, typename Piece>
std::vector<Instance> regionsInPieces(Kind kind, const std::vector<Fractions>& pairs, std::size_t wholes,
                                      double tolerance, Whole whole, Piece piece) {
  struct Sum {
    std::vector<std::size_t> pieces;
    double covered = 0.0;
    double of_pieces = 0.0;
  };
  std::vector<Sum> sums(wholes);
  for (const Fractions& pair : pairs) {
    if (!reaches(piece(pair).second, tolerance)) continue;
    Sum& sum = sums[whole(pair).first];
    sum.pieces.push_back(piece(pair).first);
    sum.covered += whole(pair).second;
    sum.of_pieces += piece(pair).second;
  }

  std::vector<Instance> instances;
  for (std::size_t i = 0; i < wholes; ++i) {
    const Sum& sum = sums[i];
    if (sum.pieces.size() < 2 || !reaches(sum.covered, tolerance)) continue;
    Instance instance{
        kind, {i}, sum.pieces, (sum.covered + sum.of_pieces) / static_cast<double>(sum.pieces.size() + 1)};
    if (kind == Kind::kUnderSegmented) std::swap(instance.truth, instance.labels);
    instances.push_back(instance);
  }
  return instances;
}

std::vector<Instance> findInstances(const RegionOverlaps& regions, const std::vector<Fractions>& pairs,
                                    double tolerance) {
  const auto truth_of = [](const Fractions& pair) { return std::make_pair(pair.truth, pair.of_truth); };
  const auto label_of = [](const Fractions& pair) { return std::make_pair(pair.label, pair.of_label); };

  std::vector<Instance> all;
  for (const Fractions& pair : pairs) {
    if (!isMutual(pair, tolerance)) continue;
    all.push_back({Kind::kCorrect, {pair.truth}, {pair.label}, (pair.of_truth + pair.of_label) / 2.0});
  }
  const auto over =
      regionsInPieces(Kind::kOverSegmented, pairs, regions.truth.size(), tolerance, truth_of, label_of);
  const auto under =
      regionsInPieces(Kind::kUnderSegmented, pairs, regions.labels.size(), tolerance, label_of, truth_of);
  all.insert(all.end(), over.begin(), over.end());
  all.insert(all.end(), under.begin(), under.end());
  return all;
}

bool anyTaken(const std::vector<std::size_t>& indices, const std::vector<bool>& taken) {
  return std::any_of(indices.begin(), indices.end(), [&taken](std::size_t i) { return taken[i]; });
}

void take(const std::vector<std::size_t>& indices, std::vector<bool>& taken) {
  for (const std::size_t i : indices) taken[i] = true;
}

int count(const std::vector<bool>& flags, bool value) {
  return static_cast<int>(std::count(flags.begin(), flags.end(), value));
}

}  // namespace

HooverCounts& HooverCounts::operator+=(const HooverCounts& other) {
  required += other.required;
  labels += other.labels;
  correct += other.correct;
  over_segmented += other.over_segmented;
  under_segmented += other.under_segmented;
  merged += other.merged;
  missed += other.missed;
  noise += other.noise;
  one_to_one += other.one_to_one;
  return *this;
}

HooverCounts classifyRegions(const RegionOverlaps& regions, double tolerance, std::int64_t min_pixels) {
  std::vector<bool> truth_taken(regions.truth.size(), false);
  std::vector<bool> label_taken(regions.labels.size(), false);
  HooverCounts counts;
  counts.labels = static_cast<int>(regions.labels.size());

  std::vector<Fractions> required_pairs;
  for (const Fractions& pair : fractionsOf(regions)) {
    const bool mutual = isMutual(pair, tolerance);
    if (regions.truth[pair.truth].pixels >= min_pixels) {
      required_pairs.push_back(pair);
      counts.one_to_one += mutual ? 1 : 0;
    } else if (mutual) {
      label_taken[pair.label] = true;
    }
  }
  for (std::size_t i = 0; i < regions.truth.size(); ++i)
    truth_taken[i] = regions.truth[i].pixels < min_pixels;
  counts.required = count(truth_taken, false);

  std::vector<Instance> instances = findInstances(regions, required_pairs, tolerance);
  std::stable_sort(instances.begin(), instances.end(), [](const Instance& a, const Instance& b) {
    return std::make_tuple(-a.average, a.kind) < std::make_tuple(-b.average, b.kind);
  });
  for (const Instance& instance : instances) {
    if (anyTaken(instance.truth, truth_taken) || anyTaken(instance.labels, label_taken)) continue;
    take(instance.truth, truth_taken);
    take(instance.labels, label_taken);
    if (instance.kind == Kind::kCorrect) ++counts.correct;
    if (instance.kind == Kind::kOverSegmented) ++counts.over_segmented;
    if (instance.kind == Kind::kUnderSegmented) {
      ++counts.under_segmented;
      counts.merged += static_cast<int>(instance.truth.size());
    }
  }
  counts.missed = count(truth_taken, false);
  counts.noise = count(label_taken, false);
  return counts;
}

}  // namespace line_plane_segmentation
