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
  /// @param image  its labels are k + 1 for cluster k, 0 for no plane, and kNoDepthLabel, which becomes 0
  /// @return the number of planes left
  int clean(const DepthImage& depth, const ViewRays& rays, const std::vector<PatchCluster>& clusters,
            const Parameters& parameters, LabelRuns& image);

  /// The cluster of a label of the image last cleaned.
  int clusterOf(int label) const { return order_[static_cast<std::size_t>(label - 1)] - 1; }

 private:
  /// A connected piece of one label.
  struct Piece {
    std::uint16_t label = 0;
    std::uint16_t heir = 0;  ///< what most of its border touches, or 0; of a small piece
    bool is_small = false;   ///< it may go to its heir
    int pixels = 0;
    int lead = 0;              ///< of the heir while it is voted for
    int border = 0, held = 0;  ///< [px] that it shares with large pieces, and of them with the heir
    double error = 0.0;        ///< its pixels' errors to the heir's plane, in tolerances
  };
  /// Two runs with depths and of different labels, the first one above or to the left of the second.
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
  void connect(const LabelRuns& image);
  void listPieces(int min_region_pixels, const LabelRuns& image);
  void keepBordersOfSmall();
  void findContacts(const DepthImage& depth, const Parameters& parameters, const LabelRuns& image);
  void chooseHeirs();
  void dropFarHeirs(const DepthImage& depth, const ViewRays& rays, const std::vector<PatchCluster>& clusters,
                    const Parameters& parameters, const LabelRuns& image);
  int renumber(int min_plane_inliers, int label_count);

  std::vector<int> piece_of_;  // of each run; before the pieces are listed, another run of the piece
  std::vector<Piece> pieces_;  // the first one is of all pixels without depth
  std::vector<Border> borders_;
  std::size_t border_count_ = 0;
  std::vector<Contact> contacts_;
  std::vector<int> label_pixels_, order_;
  std::vector<std::uint16_t> new_label_;  // of each label
};

}  // namespace line_plane_segmentation
