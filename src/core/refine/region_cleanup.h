// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "depth/depth_image.h"
#include "line_plane_segmentation/parameters.h"
#include "planes/plane_clustering.h"
#include "refine/label_runs.h"

namespace line_plane_segmentation {

/// Refinement: tidies a label image. A connected piece of fewer than min_region_pixels, or of eight times as
/// many if it is of no plane, becomes part of what most of its border touches without a step in depth, so
/// that noise leaves no speckles and no pinholes, and distortion no gaps, unless it lies off that plane; then
/// planes that are too small go, and the rest are numbered from 1, the largest first.
class RegionCleaner {
 public:
  /// @param image  its labels are k + 1 for cluster k, 0 for no plane, and kNoDepthLabel, which becomes 0
  /// @return the number of planes left
  int clean(const DepthImage& depth, const ViewRays& rays, const std::vector<PlaneCluster>& clusters,
            const Parameters& parameters, LabelRuns& image);

  /// The cluster of a label of the image last cleaned.
  int clusterOf(int label) const { return order_[label - 1] - 1; }

 private:
  /// Pieces without depth border on nothing; only small ones may go to an target_label.
  enum Size : std::uint8_t { kNoDepth = 0, kSmall = 1, kLarge = 2 };

  /// A connected piece of one label.
  struct Component {
    std::uint16_t label = 0;
    std::uint16_t target_label = 0;  ///< what most of its border touches, or 0; of a small piece
    Size size = kNoDepth;
    int pixels = 0;
    int vote_count = 0;  ///< of the target_label while it is voted for
    int majority_margin =
        0;  ///< [px] of its border with large pieces: twice what the target_label holds, less all of it
  };
  /// Two runs that touch, the first one above or to the left of the second.
  struct Border {
    int first, second;
  };
  /// Pixels of a small piece that touch a large one.
  struct Contact {
    int piece;
    std::uint16_t label;  ///< of the large one
    int length;
  };

  int find(int run);
  Component& componentOf(int run) { return components_[component_of_run_[run]]; }
  void connect(const LabelRuns& image);
  void growBorders();
  /// All are stored and the right ones counted: a branch would be mispredicted.
  void addBorderIf(bool is_border, const Border& border) {
    if (border_count_ == borders_.size()) growBorders();
    borders_[border_count_] = border;
    border_count_ += is_border ? 1U : 0U;
  }
  void numberComponents(const LabelRuns& image);
  void measureComponents(int min_region_pixels, const LabelRuns& image);
  void listBordersOfSmall(const LabelRuns& image);
  void findContacts(const DepthImage& depth, const Parameters& parameters, const LabelRuns& image);
  void chooseMergeTargets();
  void rejectDistantTargets(const DepthImage& depth, const ViewRays& rays,
                            const std::vector<PlaneCluster>& clusters, const Parameters& parameters,
                            const LabelRuns& image);
  int renumber(int min_plane_inliers, int label_count);

  std::vector<int>
      component_of_run_;  // of each run; before pieces have numbers, an earlier run of it, or itself
  std::vector<Component> components_;  // the first one is of all pixels without depth
  std::vector<double> errors_;         // of each piece's pixels to the target_label's plane, in tolerances
  std::vector<Border> borders_;        // the first ones, as many as are counted
  std::size_t border_count_ = 0;
  std::vector<Contact> contacts_;
  std::vector<int> label_pixels_, order_;
  std::vector<std::uint16_t> new_label_;  // of each label
};

}  // namespace line_plane_segmentation
