// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/pixel_assignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "row_kernels.h"

namespace line_plane_segmentation {
namespace {

constexpr int kMaxSpeckle = 3;            // [px]
constexpr float kMaxSpeckleError = 2.0F;  // [-] in tolerances

// [-] in tolerances along the ray; planes that differ by less are told apart by the line where they meet.
constexpr double kCreaseReach = 0.5;

}  // namespace

// A patch speaks for its own tile of the grid and for the eight around it.
void PixelAssigner::findSpans(const Tiles& tiles, int row, int width, std::vector<Span>& spans) {
  spans.clear();
  const int* const here = tiles.cluster_at + row * tiles.columns;
  const std::array<const int*, 3> rows = {row > 0 ? here - tiles.columns : here, here,
                                          row + 1 < tiles.rows ? here + tiles.columns : here};
  for (int c = 0; c < tiles.columns; ++c) {
    // Only -1, all of whose bits are set, is negative.
    if ((rows[0][c] & rows[1][c] & rows[2][c]) < 0) continue;
    const int first = std::max(0, c - 1) * tiles.spacing;
    const int last = c + 2 >= tiles.columns ? width : (c + 2) * tiles.spacing;
    for (const int* clusters : rows) {
      const int cluster = clusters[c];
      if (cluster < 0) continue;
      int& open = open_span_[static_cast<std::size_t>(cluster)];
      if (open >= 0 && spans[static_cast<std::size_t>(open)].last >= first) {
        spans[static_cast<std::size_t>(open)].last = last;
      } else {
        open = static_cast<int>(spans.size());
        spans.push_back({cluster, first, last});
      }
    }
  }
  for (const Span& span : spans) open_span_[static_cast<std::size_t>(span.cluster)] = -1;
}

void PixelAssigner::assignSpans(const std::vector<Span>& spans, const std::vector<PatchCluster>& clusters,
                                const float* z, const ViewRays& rays, double y) {
  for (const Span& span : spans) {
    const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(span.cluster)].plane;
    const RowOfPlane row{static_cast<float>(plane.a), static_cast<float>(plane.b * y + plane.c),
                         inverse_across_[static_cast<std::size_t>(span.cluster)],
                         static_cast<std::uint16_t>(span.cluster + 1)};
    assignIfBetter(z + span.first, depth_over_noise_.data() + span.first, rays.x.data() + span.first,
                   span.last - span.first, row, best_.data() + span.first, label_.data() + span.first);
  }
}

// Where planes meet that are asked in the same columns, from the row with the ray y on.
void PixelAssigner::findMeetings(const std::vector<PatchCluster>& clusters, const ViewRays& rays, double y,
                                 const DepthTolerance& tolerance) {
  meetings_.clear();
  if (rays.x.size() < 2 || creases_.empty()) return;
  const double x0 = static_cast<double>(rays.x.front());
  const double x_step = (static_cast<double>(rays.x.back()) - x0) / static_cast<double>(rays.x.size() - 1);
  const auto meet = [&](const Span& a, const Span& b) {
    const int first = std::max(a.first, b.first), last = std::min(a.last, b.last);
    if (a.cluster == b.cluster || first >= last) return;
    const Fold fold = creases_.between(a.cluster, b.cluster);
    const InverseDepthPlane& plane = clusters[static_cast<std::size_t>(a.cluster)].plane;
    const InverseDepthPlane& other = clusters[static_cast<std::size_t>(b.cluster)].plane;
    // By how much the first is nearer, in inverse depth, grows by this from column to column.
    const double slope = (plane.a - other.a) * x_step;
    if (fold == Fold::kNone || slope == 0.0) return;
    Meeting meeting{first,
                    last,
                    (other.at(x0, 0.0) - plane.at(x0, 0.0)) / slope,
                    (other.b - plane.b) / slope,
                    0.0,
                    static_cast<std::uint16_t>(a.cluster + 1),
                    static_cast<std::uint16_t>(b.cluster + 1)};
    const double crossing = std::clamp(meeting.offset + meeting.per_y * y, first + 0.0, last + 0.0);
    meeting.reach = tolerance.along(plane.at(x0 + x_step * crossing, y)) / std::fabs(slope);
    if ((slope < 0.0) != (fold == Fold::kInward)) std::swap(meeting.left, meeting.right);
    meetings_.push_back(meeting);
  };
  // Spans are in the order of their first columns.
  const auto meetAll = [&](const Span& span, const std::vector<Span>& others, std::size_t from) {
    for (std::size_t k = from; k < others.size() && others[k].first < span.last; ++k) meet(span, others[k]);
  };
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    meetAll(spans_[i], spans_, i + 1);
    meetAll(spans_[i], fine_spans_, 0);
  }
  for (std::size_t i = 0; i < fine_spans_.size(); ++i) meetAll(fine_spans_[i], fine_spans_, i + 1);
}

// Near the line where two planes meet, noise decides which one a pixel fits better. There it goes to the
// plane on its side of the line.
void PixelAssigner::partAtCreases(double y) {
  for (const Meeting& meeting : meetings_) {
    const double crossing = meeting.offset + meeting.per_y * y;
    const double begin = std::max(crossing - meeting.reach, meeting.first + 0.0);
    const double end = std::min(crossing + meeting.reach, meeting.last - 1.0);
    if (!(begin <= end)) continue;
    const int last = static_cast<int>(end);
    for (int u = static_cast<int>(std::ceil(begin)); u <= last; ++u) {
      std::uint16_t& label = label_[static_cast<std::size_t>(u)];
      const bool is_of_these = (label == meeting.left) | (label == meeting.right);
      const std::uint16_t side = u < crossing ? meeting.left : meeting.right;
      label = is_of_these ? side : label;
    }
  }
}

// Whether a few pixels of a row lie at the depth of those to their left and right.
bool PixelAssigner::isLikeNeighbors(const float* z, const LabelRun& before, const LabelRun& speckle,
                                    const LabelRun& after) const {
  const float expected = 0.5F * (1.0F / z[before.last - 1] + 1.0F / z[after.first]);
  bool is_like = true;
  for (int u = speckle.first; u < speckle.last; ++u) {
    const float error = std::fabs(1.0F - z[u] * expected) * depth_over_noise_[static_cast<std::size_t>(u)];
    is_like &= !(error > kMaxSpeckleError);
  }
  return is_like;
}

void PixelAssigner::assign(const DepthImage& depth, const ViewRays& rays, const PatchLevels& levels,
                           const std::vector<PatchCluster>& clusters, const std::vector<int>& cluster_of,
                           const Parameters& parameters, LabelRuns& image) {
  const std::size_t width = static_cast<std::size_t>(depth.width);
  for (std::vector<float>* row : {&depth_over_noise_, &best_}) row->resize(width);
  label_.resize(width);
  open_span_.assign(clusters.size(), -1);
  const float factor = static_cast<float>(parameters.extraction.distance_noise_factor);
  const RowNoise noise{static_cast<float>(parameters.noise.floor) * factor,
                       static_cast<float>(parameters.noise.growth) * factor,
                       static_cast<float>(parameters.noise.nearest)};

  levels.coarse.spread(cluster_of, 0, coarse_cluster_);
  levels.fine.spread(cluster_of, levels.firstFine(), fine_cluster_);
  const Tiles coarse{levels.coarse.spacing, levels.coarse.columns, levels.coarse.rows,
                     coarse_cluster_.data()};
  const Tiles fine{levels.fine.spacing, levels.fine.columns, levels.fine.rows, fine_cluster_.data()};
  inverse_across_.clear();
  for (const PatchCluster& cluster : clusters) {
    const double across = parameters.extraction.plane_distance * cluster.plane.inverseDistance();
    inverse_across_.push_back(static_cast<float>(1.0 / across));
  }

  const DepthTolerance crease_tolerance{parameters.noise,
                                        kCreaseReach * parameters.extraction.distance_noise_factor};
  creases_.find(rays, levels.coarse, clusters, coarse_cluster_);

  image.clear();
  spans_.clear();
  fine_spans_.clear();
  meetings_.clear();
  for (int v = 0, row = -1, fine_row = -1; v < depth.height; ++v) {
    const auto enter = [&](const Tiles& tiles, int& entered, std::vector<Span>& spans) {
      const int tile_row = std::min(v / tiles.spacing, tiles.rows - 1);
      if (tile_row == entered) return false;
      findSpans(tiles, tile_row, depth.width, spans);
      entered = tile_row;
      return true;
    };
    const double y = rays.y[static_cast<std::size_t>(v)];
    bool are_other_spans = enter(coarse, row, spans_);
    if (!levels.fine.patches.empty()) are_other_spans |= enter(fine, fine_row, fine_spans_);
    if (are_other_spans) findMeetings(clusters, rays, y, crease_tolerance);
    const float* z = depth.row(v);
    prepareRow(z, depth.width, noise, depth_over_noise_.data(), best_.data(), label_.data());
    assignSpans(spans_, clusters, z, rays, y);
    assignSpans(fine_spans_, clusters, z, rays, y);
    partAtCreases(y);
    image.addRow(label_.data(), depth.width);
    image.joinOverSpeckles(kMaxSpeckle,
                           [this, z](const LabelRun& before, const LabelRun& speckle, const LabelRun& after) {
                             return isLikeNeighbors(z, before, speckle, after);
                           });
  }
}

}  // namespace line_plane_segmentation
