// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/region_cleanup.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace line_plane_segmentation {
namespace {

constexpr double kMaxMeanError =
    2.0;  // [-] in tolerances; a piece farther from the plane around it is not of it

// Where a plane of the sensor's bends, as it does in the corners of the picture, pixels in no plane lie
// beside it without a step, in larger pieces than noise makes.
constexpr int kMaxGapRegions = 8;  // [-] in min_region_pixels; a larger piece in no plane stays in none
constexpr double kMaxStep = 1.0;   // [-] in tolerances along the ray; neighbours farther apart do not touch

// How many of two rows' pixels lie at the same depth: their inverse depths differ by less than the tolerance
// of the farther one. Multiplied by both depths and by the farther one, that takes no division.
int countTouching(const float* z, const float* other, int count, const DepthTolerance& tolerance) {
  int touching = 0;
  for (int i = 0; i < count; ++i) {
    const double near = static_cast<double>(std::min(z[i], other[i]));
    const double far = static_cast<double>(std::max(z[i], other[i]));
    const double beyond = far - tolerance.noise.nearest;
    const double noise = tolerance.noise.floor + tolerance.noise.growth * beyond * beyond;
    touching += (far - near) * far < tolerance.noise_factor * noise * near ? 1 : 0;
  }
  return touching;
}

}  // namespace

// Nearly all runs are the first of their piece or hang under it: to both the loop is the same.
int RegionCleaner::find(int run) {
  const auto parentOf = [this](int r) -> int& { return piece_of_[static_cast<std::size_t>(r)]; };
  int parent = parentOf(run);
  while (parentOf(parent) != parent) {
    parentOf(run) = parentOf(parent);
    run = parentOf(parent);
    parent = parentOf(run);
  }
  return parent;
}

// Hangs runs of one label that touch under the first of them, and lists the borders between labels.
void RegionCleaner::connect(const LabelRuns& image) {
  const std::size_t count = image.runs.size();
  piece_of_.resize(count);
  std::iota(piece_of_.begin(), piece_of_.end(), 0);
  if (borders_.size() < 3 * count) borders_.resize(3 * count);
  border_count_ = 0;
  forEachVerticalContact(image, [&](std::size_t above, std::size_t below, int) {
    const std::uint16_t label = image.runs[above].label, label_below = image.runs[below].label;
    const bool have_depth = std::max(label, label_below) != kNoDepthLabel;
    // All are stored and the right ones counted, without a branch.
    borders_[border_count_] = {static_cast<int>(above), static_cast<int>(below)};
    border_count_ += static_cast<std::size_t>((label != label_below) & have_depth);
    if (label != label_below || !have_depth) return;
    const int a = find(static_cast<int>(above)), b = find(static_cast<int>(below));
    piece_of_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  });
  for (std::size_t i = 1; i < count; ++i) {
    const LabelRun &left = image.runs[i - 1], &right = image.runs[i];
    const bool have_depth = std::max(left.label, right.label) != kNoDepthLabel;
    borders_[border_count_] = {static_cast<int>(i) - 1, static_cast<int>(i)};
    border_count_ += static_cast<std::size_t>((left.row == right.row) & have_depth);
  }
}

void RegionCleaner::listPieces(int min_region_pixels, const LabelRuns& image) {
  pieces_.assign(1, Piece{});
  const std::size_t count = image.runs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const LabelRun& run = image.runs[i];
    // A run hangs under an earlier one, whose piece is known, or is the first of a piece.
    const std::size_t parent = static_cast<std::size_t>(piece_of_[i]);
    const bool has_depth = run.label != kNoDepthLabel;
    int piece = has_depth ? piece_of_[parent] : 0;
    if (has_depth & (parent == i)) {
      piece = static_cast<int>(pieces_.size());
      pieces_.emplace_back();
      pieces_.back().label = run.label;
    }
    piece_of_[i] = piece;
    pieces_[static_cast<std::size_t>(piece)].pixels += run.pixels();
  }
  for (std::size_t i = 1; i < pieces_.size(); ++i) {
    const int bound = pieces_[i].label == 0 ? kMaxGapRegions * min_region_pixels : min_region_pixels;
    pieces_[i].is_small = pieces_[i].pixels < bound;
  }
}

// Keeps the borders between small and large pieces.
void RegionCleaner::keepBordersOfSmall() {
  const auto isSmall = [this](int run) {
    return pieces_[static_cast<std::size_t>(piece_of_[static_cast<std::size_t>(run)])].is_small;
  };
  std::size_t kept = 0;
  for (std::size_t k = 0; k < border_count_; ++k) {
    const Border border = borders_[k];
    borders_[kept] = border;
    kept += isSmall(border.first) != isSmall(border.second) ? 1U : 0U;
  }
  border_count_ = kept;
}

// Where small pieces touch large ones.
void RegionCleaner::findContacts(const DepthImage& depth, const Parameters& parameters,
                                 const LabelRuns& image) {
  contacts_.clear();
  const DepthTolerance tolerance{parameters.noise, kMaxStep * parameters.extraction.distance_noise_factor};
  for (std::size_t k = 0; k < border_count_; ++k) {
    const std::size_t i = static_cast<std::size_t>(borders_[k].first);
    const std::size_t j = static_cast<std::size_t>(borders_[k].second);
    const LabelRun &a = image.runs[i], &b = image.runs[j];
    const bool are_beside = a.row == b.row;
    const int first = std::max(a.first, b.first);
    const int length = are_beside ? 1 : std::min(a.last, b.last) - first;
    const int touching = countTouching(depth.row(a.row) + (are_beside ? first - 1 : first),
                                       depth.row(b.row) + first, length, tolerance);
    const bool a_is_small = pieces_[static_cast<std::size_t>(piece_of_[i])].is_small;
    const int piece = piece_of_[a_is_small ? i : j];
    pieces_[static_cast<std::size_t>(piece)].border += length;
    contacts_.push_back({piece, a_is_small ? b.label : a.label, touching});
  }
}

// The label that more than half of a small piece's border touches, or 0: no plane. What lies behind a step
// touches nothing.
void RegionCleaner::chooseHeirs() {
  // Boyer and Moore's vote: a label that has more than half leads in the end. Factors stand for branches,
  // which would be mispredicted.
  for (const Contact& contact : contacts_) {
    Piece& piece = pieces_[static_cast<std::size_t>(contact.piece)];
    const int sign = 2 * static_cast<int>(contact.label == piece.heir) - 1;
    const int lead = piece.lead + sign * contact.length;
    piece.heir = lead < 0 ? contact.label : piece.heir;
    piece.lead = std::abs(lead);
  }
  for (const Contact& contact : contacts_) {
    Piece& piece = pieces_[static_cast<std::size_t>(contact.piece)];
    piece.held += contact.length * static_cast<int>(contact.label == piece.heir);
  }
  for (Piece& piece : pieces_) {
    if (2 * piece.held <= piece.border) piece.heir = 0;
  }
}

// A small piece goes to its heir only if its pixels lie near that plane.
void RegionCleaner::dropFarHeirs(const DepthImage& depth, const ViewRays& rays,
                                 const std::vector<PatchCluster>& clusters, const Parameters& parameters,
                                 const LabelRuns& image) {
  const NoiseParameters& noise = parameters.noise;
  const double factor = parameters.extraction.distance_noise_factor;
  for (std::size_t i = 0; i < image.runs.size(); ++i) {
    Piece& piece = pieces_[static_cast<std::size_t>(piece_of_[i])];
    if (piece.heir == 0) continue;
    const LabelRun& run = image.runs[i];
    const InverseDepthPlane& plane = clusters[piece.heir - 1U].plane;
    const double y = rays.y[static_cast<std::size_t>(run.row)];
    const double across = parameters.extraction.plane_distance * plane.inverseDistance();
    const float* z_of = depth.row(run.row);
    for (int u = run.first; u < run.last; ++u) {
      // The error in inverse depth over DepthTolerance::at(), both times z², which leaves one division.
      const double z = z_of[u], beyond = z - noise.nearest;
      const double expected = plane.at(rays.x[static_cast<std::size_t>(u)], y);
      const double tolerance = std::max(factor * (noise.floor + noise.growth * beyond * beyond), across * z);
      piece.error += std::fabs(z - z * z * expected) / tolerance;
    }
  }
  for (Piece& piece : pieces_) {
    if (piece.error > kMaxMeanError * piece.pixels) piece.heir = 0;
  }
}

// What the pieces come to, by their new labels; then those of the planes that are left.
int RegionCleaner::renumber(int min_plane_inliers, int label_count) {
  label_pixels_.assign(static_cast<std::size_t>(label_count) + 1, 0);
  for (Piece& piece : pieces_) {
    if (piece.is_small) piece.label = piece.heir;
    label_pixels_[piece.label] += piece.pixels;
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
  for (Piece& piece : pieces_) piece.label = new_label_[piece.label];
  return static_cast<int>(order_.size());
}

int RegionCleaner::clean(const DepthImage& depth, const ViewRays& rays,
                         const std::vector<PatchCluster>& clusters, const Parameters& parameters,
                         LabelRuns& image) {
  connect(image);
  listPieces(parameters.cleanup.min_region_pixels, image);
  keepBordersOfSmall();
  findContacts(depth, parameters, image);
  chooseHeirs();
  dropFarHeirs(depth, rays, clusters, parameters, image);
  const int plane_count =
      renumber(parameters.extraction.min_plane_inliers, static_cast<int>(clusters.size()));
  for (std::size_t i = 0; i < image.runs.size(); ++i) {
    image.runs[i].label = pieces_[static_cast<std::size_t>(piece_of_[i])].label;
  }
  image.join();
  return plane_count;
}

}  // namespace line_plane_segmentation
