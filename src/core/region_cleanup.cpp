// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/region_cleanup.h"

#include <algorithm>
#include <cmath>

namespace line_plane_segmentation {
namespace {

constexpr double kMaxMeanError =
    2.0;  // [-] in tolerances; a piece farther from the plane around it is not of it

// Where a plane of the sensor's bends, as it does in the corners of the picture, pixels in no plane lie
// beside it without a step, in larger pieces than noise makes.
constexpr int kMaxGapRegions = 8;  // [-] in min_region_pixels; a larger piece in no plane stays in none
constexpr double kMaxStep = 1.0;   // [-] in tolerances along the ray; neighbours farther apart do not touch

// How many of two rows' pixels lie at the same depth, within the tolerance.
int countTouching(const float* z, const float* other, int count, const DepthTolerance& tolerance) {
  int touching = 0;
  for (int i = 0; i < count; ++i) {
    const double w = 1.0 / static_cast<double>(z[i]), w_other = 1.0 / static_cast<double>(other[i]);
    touching += std::fabs(w - w_other) < tolerance.along(std::min(w, w_other)) ? 1 : 0;
  }
  return touching;
}

}  // namespace

int RegionCleaner::find(int run) {
  while (parent_[static_cast<std::size_t>(run)] != run) {
    int& parent = parent_[static_cast<std::size_t>(run)];
    parent = parent_[static_cast<std::size_t>(parent)];
    run = parent;
  }
  return run;
}

void RegionCleaner::connect(const LabelRuns& image) {
  parent_.resize(image.runs.size());
  for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = static_cast<int>(i);
  forEachVerticalContact(image, [&](std::size_t above, std::size_t below, int) {
    if (image.runs[above].label != image.runs[below].label) return;
    const int a = find(static_cast<int>(above)), b = find(static_cast<int>(below));
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  });
  pixels_.assign(parent_.size(), 0);
  for (std::size_t i = 0; i < parent_.size(); ++i) {
    parent_[i] = find(static_cast<int>(i));
    pixels_[static_cast<std::size_t>(parent_[i])] += image.runs[i].pixels();
  }
}

// Which runs are of a piece so small that it may go to what surrounds it.
void RegionCleaner::markSmall(int min_region_pixels, const LabelRuns& image) {
  is_small_.resize(image.runs.size());
  for (std::size_t i = 0; i < is_small_.size(); ++i) {
    const std::uint16_t label = image.runs[i].label;
    const int bound = label == 0 ? kMaxGapRegions * min_region_pixels : min_region_pixels;
    const bool is_small = pixels_[static_cast<std::size_t>(parent_[i])] < bound;
    is_small_[i] = (label != kNoDepthLabel) & is_small ? 1 : 0;
  }
}

void RegionCleaner::addContact(int piece, std::uint16_t label, int length) {
  int& first = first_contact_[static_cast<std::size_t>(piece)];
  for (int i = first; i >= 0; i = contacts_[static_cast<std::size_t>(i)].next) {
    if (contacts_[static_cast<std::size_t>(i)].label != label) continue;
    contacts_[static_cast<std::size_t>(i)].length += length;
    return;
  }
  contacts_.push_back({label, length, first});
  first = static_cast<int>(contacts_.size()) - 1;
}

// What the small pieces touch, as lengths of border; where there is a step in depth they touch label 0.
void RegionCleaner::findContacts(const DepthImage& depth, const Parameters& parameters,
                                 const LabelRuns& image) {
  contacts_.clear();
  first_contact_.assign(parent_.size(), -1);
  const DepthTolerance tolerance{parameters.noise, kMaxStep * parameters.extraction.distance_noise_factor};
  // Pixels of run i from column `first_i` on, and their neighbours of run j.
  const auto meet = [&](std::size_t i, std::size_t j, int first_i, int first_j, int length) {
    if (is_small_[i] == is_small_[j]) return;
    const LabelRun &a = image.runs[i], &b = image.runs[j];
    if (a.label == kNoDepthLabel || b.label == kNoDepthLabel) return;
    const bool a_is_small = is_small_[i] != 0;
    const int touching =
        countTouching(depth.row(a.row) + first_i, depth.row(b.row) + first_j, length, tolerance);
    const int piece = parent_[a_is_small ? i : j];
    if (touching > 0) addContact(piece, a_is_small ? b.label : a.label, touching);
    if (touching < length) addContact(piece, 0, length - touching);
  };
  forEachVerticalContact(image, [&](std::size_t above, std::size_t below, int length) {
    const int first = std::max(image.runs[above].first, image.runs[below].first);
    meet(above, below, first, first, length);
  });
  for (std::size_t i = 1; i < image.runs.size(); ++i) {
    const int first = image.runs[i].first;
    if (image.runs[i].row == image.runs[i - 1].row) meet(i - 1, i, first - 1, first, 1);
  }
}

// The label that holds more than half of a small piece's border, or 0: no plane.
std::uint16_t RegionCleaner::mostTouched(int piece) const {
  int longest = 0, total = 0;
  std::uint16_t label = 0;
  for (int i = first_contact_[static_cast<std::size_t>(piece)]; i >= 0;) {
    const Contact& contact = contacts_[static_cast<std::size_t>(i)];
    total += contact.length;
    if (contact.length > longest) {
      longest = contact.length;
      label = contact.label;
    }
    i = contact.next;
  }
  return 2 * longest > total ? label : std::uint16_t{0};
}

int RegionCleaner::renumber(int min_plane_inliers, int label_count, LabelRuns& image) {
  label_pixels_.assign(static_cast<std::size_t>(label_count) + 1, 0);
  for (const LabelRun& run : image.runs) {
    if (run.label != kNoDepthLabel) label_pixels_[run.label] += run.pixels();
  }
  order_.clear();
  for (int label = 1; label <= label_count; ++label) {
    const int pixels = label_pixels_[static_cast<std::size_t>(label)];
    if (pixels > 0 && pixels >= min_plane_inliers) order_.push_back(label);
  }
  std::sort(order_.begin(), order_.end(), [this](int a, int b) {
    const int pa = label_pixels_[static_cast<std::size_t>(a)],
              pb = label_pixels_[static_cast<std::size_t>(b)];
    return pa != pb ? pa > pb : a < b;
  });
  new_label_.assign(label_pixels_.size(), 0);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    new_label_[static_cast<std::size_t>(order_[i])] = static_cast<std::uint16_t>(i + 1);
  }
  for (LabelRun& run : image.runs) {
    if (run.label != kNoDepthLabel) run.label = new_label_[run.label];
  }
  return static_cast<int>(order_.size());
}

// Each small piece's new label: what most of its border touches, if its pixels lie near that plane.
void RegionCleaner::chooseLabels(const DepthImage& depth, const ViewRays& rays,
                                 const std::vector<PatchCluster>& clusters, const Parameters& parameters,
                                 const LabelRuns& image) {
  const DepthTolerance tolerance{parameters.noise, parameters.extraction.distance_noise_factor,
                                 parameters.extraction.plane_distance};
  new_label_.assign(image.runs.size(), 0);
  error_.assign(image.runs.size(), 0.0);
  for (std::size_t i = 0; i < image.runs.size(); ++i) {
    if (is_small_[i] == 0) continue;
    const LabelRun& run = image.runs[i];
    const std::size_t piece = static_cast<std::size_t>(parent_[i]);
    if (piece == i) new_label_[piece] = mostTouched(parent_[i]);  // its first run
    if (new_label_[piece] == 0) continue;
    const InverseDepthPlane& plane = clusters[new_label_[piece] - 1U].plane;
    const double inverse_distance = plane.inverseDistance(), y = rays.y[static_cast<std::size_t>(run.row)];
    const float* z = depth.row(run.row);
    for (int u = run.first; u < run.last; ++u) {
      const double w = 1.0 / static_cast<double>(z[u]);
      const double expected = plane.at(rays.x[static_cast<std::size_t>(u)], y);
      error_[piece] += std::fabs(w - expected) / tolerance.at(w, inverse_distance);
    }
  }
  for (std::size_t piece = 0; piece < image.runs.size(); ++piece) {
    if (error_[piece] > kMaxMeanError * pixels_[piece]) new_label_[piece] = 0;
  }
}

int RegionCleaner::clean(const DepthImage& depth, const ViewRays& rays,
                         const std::vector<PatchCluster>& clusters, const Parameters& parameters,
                         LabelRuns& image) {
  connect(image);
  markSmall(parameters.cleanup.min_region_pixels, image);
  findContacts(depth, parameters, image);
  chooseLabels(depth, rays, clusters, parameters, image);
  for (std::size_t i = 0; i < image.runs.size(); ++i) {
    if (is_small_[i] != 0) image.runs[i].label = new_label_[static_cast<std::size_t>(parent_[i])];
  }
  const int plane_count =
      renumber(parameters.extraction.min_plane_inliers, static_cast<int>(clusters.size()), image);
  image.join();
  return plane_count;
}

}  // namespace line_plane_segmentation
