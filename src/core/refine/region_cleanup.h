// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "planes/plane_clustering.h"
#include "refine/label_runs.h"

namespace line_plane_segmentation {

/// Refinement of a label image by region merging. A connected component smaller than min_region_pixels gets
/// the label that most of its border touches without a depth step, unless its pixels are too far from that
/// plane. This removes speckles and pinholes of noise. Then planes that are too small are removed, and the
/// others numbered from 1, the largest first.
class RegionCleaner {
 public:
  /// @param image  its labels are k + 1 for cluster k, 0 for no plane, and kNoDepthLabel, which becomes 0
  /// @return the number of planes left
  int clean(const DepthImage& depth, const ViewRays& rays, const std::vector<PlaneCluster>& clusters,
            const Parameters& parameters, LabelRuns& image);

  /// The cluster of a label of the image last cleaned.
  int clusterOf(int label) const { return order_[label - 1] - 1; }

 private:
  /// Components without depth have no borders; only small ones are merged.
  enum Size : std::uint8_t { kNoDepth = 0, kSmall = 1, kLarge = 2 };

  /// A connected component of one label.
  struct Component {
    int target_label = 0;  ///< of a small component: the label to merge into, or 0
    std::uint16_t label = 0;
    Size size = kNoDepth;
    int pixels = 0;
    int vote_count = 0;  ///< of the target_label while it is voted for
    /// [px] Twice the border with target_label, minus the border with all large components.
    int majority_margin = 0;
  };
  /// Two runs that touch, the first one above or to the left of the second. After their vote: the index of
  /// the small component, and the label of the large one.
  struct Border {
    int first, second;
  };

  int find(int run);
  Component& componentOf(int run) { return components_[component_of_run_[run]]; }
  void connect(const LabelRuns& image);
  void growBorders();
  /// Stores every border, and counts it if it is one: a branch would be mispredicted.
  void addBorderIf(bool is_border, const Border& border) {
    if (border_count_ == borders_.size()) growBorders();
    borders_[border_count_] = border;
    border_count_ += is_border ? 1U : 0U;
  }
  void numberComponents(const LabelRuns& image);
  void measureComponents(int min_region_pixels, const LabelRuns& image);
  void listBordersOfSmall(const LabelRuns& image);
  void vote(Border& border, int length, int touching, const LabelRuns& image);
  void voteForTargets(const DepthImage& depth, const Parameters& parameters, const LabelRuns& image);
  void chooseMergeTargets();
  void rejectDistantTargets(const DepthImage& depth, const ViewRays& rays,
                            const std::vector<PlaneCluster>& clusters, const Parameters& parameters,
                            const LabelRuns& image);
  int renumber(int min_plane_inliers, int label_count);

  std::vector<int> component_of_run_;  // per run; before components are numbered, its parent run
  std::vector<Component> components_;  // the first one holds all pixels without depth
  std::vector<double> errors_;         // [tolerances] per component: summed distance to the target's plane
  std::vector<Border> borders_;        // the first border_count_ are valid
  std::size_t border_count_ = 0;
  std::size_t vertical_count_ = 0;  // of the borders, which come first: those between two rows
  std::vector<int> touching_;  // per border of a small and a large component: how many of its pixels touch
  std::vector<int> label_pixels_, order_;
  std::vector<std::uint16_t> new_label_;  // of each label
};

}  // namespace line_plane_segmentation
