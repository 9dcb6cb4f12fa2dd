// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "line_plane_segmentation/depth_image.h"
#include "line_plane_segmentation/label_runs.h"
#include "line_plane_segmentation/parameters.h"
#include "line_plane_segmentation/patch_clustering.h"

namespace line_plane_segmentation {

/// Refinement: tidies a label image. A connected piece of fewer than min_region_pixels, or of eight times as
/// many if it is of no plane, becomes part of what most of its border touches without a step in depth, so
/// that noise leaves no speckles and no pinholes, and distortion no gaps, unless it lies off that plane; then
/// planes that are too small go, and the rest are numbered from 1, the largest first.
class RegionCleaner {
 public:
  /// @param image  its labels are k + 1 for cluster k, 0 for no plane, and kNoDepthLabel
  /// @return the number of planes left
  int clean(const DepthImage& depth, const ViewRays& rays, const std::vector<PatchCluster>& clusters,
            const Parameters& parameters, LabelRuns& image);

  /// The cluster of a label of the image last cleaned.
  int clusterOf(int label) const { return order_[static_cast<std::size_t>(label - 1)] - 1; }

 private:
  /// A border that a small piece shares with large ones of one label.
  struct Contact {
    std::uint16_t label;
    int length;
    int next;  ///< another contact of the same piece, or -1
  };

  int find(int run);
  void connect(const LabelRuns& image);
  void markSmall(int min_region_pixels, const LabelRuns& image);
  void addContact(int piece, std::uint16_t label, int length);
  void findContacts(const DepthImage& depth, const Parameters& parameters, const LabelRuns& image);
  std::uint16_t mostTouched(int piece) const;
  void chooseLabels(const DepthImage& depth, const ViewRays& rays, const std::vector<PatchCluster>& clusters,
                    const Parameters& parameters, const LabelRuns& image);
  int renumber(int min_plane_inliers, int label_count, LabelRuns& image);

  std::vector<int> parent_;             // of each run
  std::vector<int> pixels_;             // of the piece, at its root
  std::vector<std::uint8_t> is_small_;  // of each run, whether its piece is
  std::vector<int> first_contact_;      // of the piece, at its root
  std::vector<Contact> contacts_;
  std::vector<std::uint16_t> new_label_;  // of the piece, at its root; then of each label
  std::vector<double> error_;             // of the piece off the plane around it, at its root
  std::vector<int> label_pixels_, order_;
};

}  // namespace line_plane_segmentation
