// SPDX-License-Identifier: BSD-3-Clause
#include "refine/region_cleanup.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "kernels/sparing_growth.h"

namespace line_plane_segmentation {
namespace {

// [tolerances] Mean distance up to which a small component is merged into the plane around it.
constexpr double kMaxMeanError = 2.0;

// Whether neighbouring pixels lie at the same depth: their inverse depths differ by less than the tolerance
// of the farther one. Multiplied by both depths and by the farther one, that takes no division.
class StepTest {
 public:
  explicit StepTest(const Parameters& parameters)
      : floor_(static_cast<float>(parameters.extraction.distance_noise_factor * parameters.noise.floor)),
        growth_(static_cast<float>(parameters.extraction.distance_noise_factor * parameters.noise.growth)),
        nearest_(static_cast<float>(parameters.noise.nearest)) {}

  int touch(float a, float b) const {
    const float near = std::min(a, b), far = std::max(a, b), beyond = far - nearest_;
    return (far - near) * far < (floor_ + growth_ * beyond * beyond) * near ? 1 : 0;
  }
  int countTouching(const float* z, const float* other, int count) const {
    int touching = 0;
    for (int i = 0; i < count; ++i) touching += touch(z[i], other[i]);
    return touching;
  }

 private:
  float floor_, growth_, nearest_;
};

}  // namespace

// The root of a run's component. Most runs are a root or the child of one, for which the loop ends at once.
int RegionCleaner::find(int run) {
  const auto parent_of = [this](int r) -> int& { return component_of_run_[r]; };
  int parent = parent_of(run);
  while (parent_of(parent) != parent) {
    parent_of(run) = parent_of(parent);
    run = parent_of(parent);
    parent = parent_of(run);
  }
  return parent;
}

// Hangs runs of one label that touch under the first of them, and lists the borders between labels.
void RegionCleaner::connect(const LabelRuns& image) {
  resizeAnew(image.runs.size(), component_of_run_);
  std::iota(component_of_run_.begin(), component_of_run_.end(), 0);
  border_count_ = 0;
  forEachVerticalContact(image, [&](std::size_t above, std::size_t below) {
    const std::uint16_t label = image.runs[above].label, label_below = image.runs[below].label;
    const bool have_depth = std::max(label, label_below) != kNoDepthLabel;
    addBorderIf((label != label_below) & have_depth, {static_cast<int>(above), static_cast<int>(below)});
    if (label != label_below || !have_depth) return;
    const int a = find(static_cast<int>(above)), b = find(static_cast<int>(below));
    component_of_run_[std::max(a, b)] = std::min(a, b);
  });
}

void RegionCleaner::growBorders() {
  reserveSparingly(borders_.size() + 1, borders_);
  borders_.resize(borders_.capacity());
}

// Numbers the components from 1; 0 stands for all runs without depth. Factors replace branches, which would
// be mispredicted.
void RegionCleaner::numberComponents(const LabelRuns& image) {
  int count = 1;
  for (std::size_t i = 0; i < component_of_run_.size(); ++i) {
    // The parent is an earlier run, which is numbered, or the run itself, which starts the next component.
    const std::size_t parent = static_cast<std::size_t>(component_of_run_[i]);
    component_of_run_[i] = count;
    const int has_depth = image.runs[i].label != kNoDepthLabel ? 1 : 0;
    component_of_run_[i] = has_depth * component_of_run_[parent];
    count += parent == i ? has_depth : 0;
  }
  resizeAnew(static_cast<std::size_t>(count), components_);
}

void RegionCleaner::measureComponents(int min_region_pixels, const LabelRuns& image) {
  for (std::size_t i = 0; i < component_of_run_.size(); ++i) {
    Component& component = components_[component_of_run_[i]];
    component.label = image.runs[i].label;
    component.pixels += image.runs[i].pixels();
  }
  for (Component& component : components_)
    component.size = component.pixels < min_region_pixels ? kSmall : kLarge;
  components_.front().label = 0;
  components_.front().size = kNoDepth;
}

// Keeps the borders between small and large components, and adds those within rows.
void RegionCleaner::listBordersOfSmall(const LabelRuns& image) {
  const auto is_of_small = [this](int i, int j) {
    return (componentOf(i).size | componentOf(j).size) == (kSmall | kLarge);
  };
  std::size_t kept = 0;
  for (std::size_t k = 0; k < border_count_; ++k) {
    const Border border = borders_[k];
    borders_[kept] = border;
    kept += is_of_small(border.first, border.second) ? 1U : 0U;
  }
  border_count_ = vertical_count_ = kept;
  for (int i = 1; i < static_cast<int>(image.runs.size()); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    addBorderIf((image.runs[at - 1].row == image.runs[at].row) & is_of_small(i - 1, i), {i - 1, i});
  }
}

// Takes the votes of a border between a small component and a large one, in which some pixels touch. The
// small one votes for the label that it may be merged into (Boyer and Moore's vote): one that more than half
// of its touching pixels have is target_label in the end. Factors stand for branches, which would be
// mispredicted.
void RegionCleaner::vote(Border& border, int length, int touching, const LabelRuns& image) {
  const bool first_is_small = componentOf(border.first).size == kSmall;
  const int small = first_is_small ? border.first : border.second;
  const int large = first_is_small ? border.second : border.first;
  const int index = component_of_run_[small], label = image.runs[large].label;
  Component& component = components_[index];
  component.majority_margin -= length;
  const int sign = 2 * static_cast<int>(label == component.target_label) - 1;
  const int vote_count = component.vote_count + sign * touching;
  component.target_label = vote_count < 0 ? label : component.target_label;
  component.vote_count = std::abs(vote_count);
  border = {index, label};
}

// Where small components touch large ones.
void RegionCleaner::voteForTargets(const DepthImage& depth, const Parameters& parameters,
                                   const LabelRuns& image) {
  resizeAnew(border_count_, touching_);
  const StepTest step(parameters);
  for (std::size_t k = 0; k < vertical_count_; ++k) {
    const LabelRun &above = image.runs[borders_[k].first], &below = image.runs[borders_[k].second];
    const int first = std::max(above.first, below.first);
    const int length = std::min(above.last, below.last) - first;
    touching_[k] = step.countTouching(depth.row(above.row) + first, depth.row(below.row) + first, length);
    vote(borders_[k], length, touching_[k], image);
  }
  for (std::size_t k = vertical_count_; k < border_count_; ++k) {
    const LabelRun& right = image.runs[borders_[k].second];
    const float* const z = depth.row(right.row) + right.first;
    touching_[k] = step.touch(z[-1], z[0]);
    vote(borders_[k], 1, touching_[k], image);
  }
}

// Keeps the target_label of a small component if more than half of its border touches it. Pixels behind a
// depth step do not touch.
void RegionCleaner::chooseMergeTargets() {
  for (std::size_t k = 0; k < border_count_; ++k) {
    const auto [component_index, label] = borders_[k];
    Component& component = components_[component_index];
    component.majority_margin += 2 * touching_[k] * static_cast<int>(label == component.target_label);
  }
  for (Component& component : components_) {
    if (component.majority_margin <= 0) component.target_label = 0;
  }
}

// A small component goes to its target_label only if its pixels lie near that plane.
void RegionCleaner::rejectDistantTargets(const DepthImage& depth, const ViewRays& rays,
                                         const std::vector<PlaneCluster>& clusters,
                                         const Parameters& parameters, const LabelRuns& image) {
  const NoiseParameters& noise = parameters.noise;
  const double factor = parameters.extraction.distance_noise_factor;
  errors_.assign(components_.size(), 0.0);
  for (std::size_t i = 0; i < image.runs.size(); ++i) {
    const std::size_t component = static_cast<std::size_t>(component_of_run_[i]);
    const int target_label = components_[component].target_label;
    if (target_label == 0) continue;
    const LabelRun& run = image.runs[i];
    const InverseDepthPlane& plane = clusters[target_label - 1].plane;
    const double y = rays.y[run.row];
    const double orthogonal_tolerance = parameters.extraction.plane_distance * plane.inverseDistance();
    const float* z_of = depth.row(run.row);
    double error = errors_[component];
    for (int u = run.first; u < run.last; ++u) {
      // The error in inverse depth over DepthTolerance::at(), both times z², which leaves one division.
      const double z = z_of[u], beyond = z - noise.nearest;
      const double expected = plane.at(rays.x[u], y);
      const double tolerance =
          std::max(factor * (noise.floor + noise.growth * beyond * beyond), orthogonal_tolerance * z);
      error += std::fabs(z - z * z * expected) / tolerance;
    }
    errors_[component] = error;
  }
  for (std::size_t i = 0; i < components_.size(); ++i) {
    if (errors_[i] > kMaxMeanError * components_[i].pixels) components_[i].target_label = 0;
  }
}

// Merges small components, removes planes that are too small, and numbers the others by size.
int RegionCleaner::renumber(int min_plane_inliers, int label_count) {
  label_pixels_.assign(static_cast<std::size_t>(label_count) + 1, 0);
  for (Component& component : components_) {
    if (component.size == kSmall) component.label = static_cast<std::uint16_t>(component.target_label);
    label_pixels_[component.label] += component.pixels;
  }
  order_.clear();
  for (int label = 1; label <= label_count; ++label) {
    const int pixels = label_pixels_[label];
    if (pixels > 0 && pixels >= min_plane_inliers) order_.push_back(label);
  }
  std::sort(order_.begin(), order_.end(), [this](int a, int b) {
    const int pa = label_pixels_[a], pb = label_pixels_[b];
    return pa != pb ? pa > pb : a < b;
  });
  new_label_.assign(label_pixels_.size(), 0);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    new_label_[order_[i]] = static_cast<std::uint16_t>(i + 1);
  }
  for (Component& component : components_) component.label = new_label_[component.label];
  return static_cast<int>(order_.size());
}

int RegionCleaner::clean(const DepthImage& depth, const ViewRays& rays,
                         const std::vector<PlaneCluster>& clusters, const Parameters& parameters,
                         LabelRuns& image) {
  connect(image);
  numberComponents(image);
  measureComponents(parameters.cleanup.min_region_pixels, image);
  listBordersOfSmall(image);
  voteForTargets(depth, parameters, image);
  chooseMergeTargets();
  rejectDistantTargets(depth, rays, clusters, parameters, image);
  const int plane_count =
      renumber(parameters.extraction.min_plane_inliers, static_cast<int>(clusters.size()));
  image.join([this](std::size_t i, const LabelRun&) { return components_[component_of_run_[i]].label; });
  return plane_count;
}

}  // namespace line_plane_segmentation
