// SPDX-License-Identifier: BSD-3-Clause
// What was reached in simulated rooms, whose planes are known exactly, is not lost again.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <vector>

#include "line_primitive_segmenter.h"
#include "quality_figures.h"
#include "simulated_rooms.h"

namespace line_plane_segmentation {
namespace {

// Chi-squared with the three degrees of freedom of a plane: 95 % of its values are below, half of them.
constexpr double kChiSquared95 = 7.815;
constexpr double kChiSquaredMedian = 2.366;

/// How far planes are from the true ones, one value a plane.
struct PlaneErrors {
  std::vector<double> angle;     ///< [degrees] between the normals
  std::vector<double> distance;  ///< [m] of the found plane's centroid from the true plane
  std::vector<double> nees;      ///< normalised estimation error squared
};

double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

// The covariance has no inverse: the normal's length is fixed. So its three directions that have a variance.
double normalisedError(const SegmentedPlane& found, const simulation::VisiblePlane& truth) {
  Eigen::Vector4d error;
  error << found.normal - truth.normal, found.d - truth.d;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(found.covariance);
  const Eigen::Vector4d along = axes.eigenvectors().transpose() * error;
  return (along.tail<3>().array().square() / axes.eigenvalues().tail<3>().array()).sum();
}

using VisiblePlanes = std::vector<simulation::VisiblePlane>;

const simulation::VisiblePlane& planeOf(const VisiblePlanes& planes, std::uint16_t label) {
  return *std::find_if(planes.begin(), planes.end(),
                       [label](const auto& plane) { return plane.label == label; });
}

/// Of all planes that were found with an IoU of at least 0.8.
void addErrors(const VisiblePlanes& planes, const Segmentation& segmentation, const RegionOverlaps& regions,
               PlaneErrors& errors) {
  for (const Overlap& overlap : regions.overlaps) {
    const CountedRegion& truth = regions.truth[overlap.truth];
    const CountedRegion& label = regions.labels[overlap.label];
    const auto shared = static_cast<double>(overlap.pixels);
    const double iou = shared / (static_cast<double>(truth.pixels + label.pixels) - shared);
    if (truth.pixels < kSimulatedMinPixels || iou < 0.8) continue;
    const SegmentedPlane& found = segmentation.planes[label.value - 1U];
    const simulation::VisiblePlane& plane = planeOf(planes, truth.value);
    const double sine = found.normal.cross(plane.normal).norm();
    errors.angle.push_back(std::atan2(sine, found.normal.dot(plane.normal)) * 180.0 / M_PI);
    errors.distance.push_back(std::abs(plane.normal.dot(found.centroid) + plane.d));
    errors.nees.push_back(normalisedError(found, plane));
  }
}

/// Pixels within four of another true plane that meets theirs without a step, both planes being found.
struct CreasePixels {
  std::size_t all = 0, right = 0;

  void add(const LabelledFrame& frame, const Segmentation& segmentation, const RegionOverlaps& regions) {
    constexpr std::size_t kReach = 4;
    constexpr double kNoStep = 0.03;  // of the depth
    const std::map<std::uint16_t, std::uint16_t> label_of = matches(regions);
    const auto width = static_cast<std::size_t>(frame.depth.cols);
    const auto height = static_cast<std::size_t>(frame.depth.rows);
    const std::uint16_t *truth = frame.truthPixels(), *depth = frame.depthPixels();
    for (std::size_t v = kReach; v + kReach < height; ++v) {
      for (std::size_t u = kReach; u + kReach < width; ++u) {
        const std::size_t here = v * width + u, across = kReach * width;
        const auto is_crease = [&](std::size_t there) {
          return truth[there] != truth[here] && label_of.count(truth[there]) != 0 &&
                 std::abs(depth[there] - depth[here]) < kNoStep * depth[here];
        };
        const auto label = label_of.find(truth[here]);
        if (label == label_of.end()) continue;
        if (!is_crease(here - kReach) && !is_crease(here + kReach) && !is_crease(here - across) &&
            !is_crease(here + across))
          continue;
        ++all;
        right += segmentation.labels[here] == label->second ? 1 : 0;
      }
    }
  }

 private:
  /// The label of each true plane that has one with an IoU over 0.5.
  static std::map<std::uint16_t, std::uint16_t> matches(const RegionOverlaps& regions) {
    std::map<std::uint16_t, std::uint16_t> label_of;
    for (const Overlap& overlap : regions.overlaps) {
      const CountedRegion &truth = regions.truth[overlap.truth], &label = regions.labels[overlap.label];
      if (3 * overlap.pixels > truth.pixels + label.pixels) label_of[truth.value] = label.value;
    }
    return label_of;
  }
};

/// The frames of a range of rooms, and what was measured on them.
struct MeasuredRooms {
  std::vector<LabelledFrame> frames;
  PlaneErrors errors;  // over uprightVariants()
  PlaneErrors as_recorded;
  CreasePixels creases;  // over uprightVariants()
};

class SimulatedQuality : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    seen() = {};
    LinePrimitiveSegmenter segmenter{Parameters{}};
    forEachSimulatedFrame(kSeenRooms, [&](const SimulatedFrame& frame) {
      seen().frames.push_back(frame.labelled());
      for (const FrameVariant& variant : uprightVariants()) {
        const LabelledFrame view = viewOf(seen().frames.back(), variant, segmenter);
        const Segmentation& segmentation = segmenter.segmentPlanes(view, variant);
        const RegionOverlaps regions =
            countOverlaps(view.truthPixels(), segmentation.labels.data(), segmentation.labels.size());
        addErrors(frame.rendering.planes, segmentation, regions, seen().errors);
        if (isAsRecorded(variant))
          addErrors(frame.rendering.planes, segmentation, regions, seen().as_recorded);
        seen().creases.add(view, segmentation, regions);
      }
    });
  }

  static MeasuredRooms& seen() {
    static MeasuredRooms rooms;
    return rooms;
  }

  static PlaneErrors& errors() { return seen().errors; }
};

std::vector<LabelledFrame> framesOf(const RoomRange& rooms) {
  std::vector<LabelledFrame> frames;
  forEachSimulatedFrame(rooms, [&](const SimulatedFrame& frame) { frames.push_back(frame.labelled()); });
  return frames;
}

void expectInRooms(const QualityFigures& floors, double max_curved,
                   const std::vector<LabelledFrame>& frames) {
  const RobustScores scores = evaluateFew(frames, {}, kSimulatedMinPixels);
  expectAtLeast(floors, scores);
  const double curved = scores.clutterInPlanes().mean;
  std::cout << "of the pixels on curved things " << 100.0 * curved << " % are in planes" << std::endl;
  EXPECT_LE(curved, max_curved);
}

TEST_F(SimulatedQuality, ofSeenRooms) {
  expectInRooms({0.79, 0.795, 0.87, 0.945, 0.96}, 0.04, seen().frames);
}

TEST_F(SimulatedQuality, ofUnseenRoomsThatDecide) {
  expectInRooms({0.835, 0.845, 0.91, 0.945, 0.95}, 0.09, framesOf(kDecidingRooms));
}

TEST_F(SimulatedQuality, ofUnseenRoomsThatConfirm) {
  expectInRooms({0.755, 0.765, 0.86, 0.945, 0.95}, 0.09, framesOf(kConfirmingRooms));
}

TEST_F(SimulatedQuality, ofPixelsWherePlanesMeet) {
  const CreasePixels& creases = seen().creases;
  ASSERT_GT(creases.all, 1200000U);
  const double fraction = static_cast<double>(creases.right) / static_cast<double>(creases.all);
  std::cout << "within 4 pixels of a crease " << 100.0 * fraction << " % are in the right plane" << std::endl;
  EXPECT_GE(fraction, 0.88);
}

TEST_F(SimulatedQuality, ofPlanes) {
  const auto& [angle, distance, nees] = errors();
  ASSERT_GT(angle.size(), 100U);
  std::cout << angle.size() << " planes; angle: median " << quantile(angle, 0.5) << ", 95 % "
            << quantile(angle, 0.95) << " degrees; distance: median " << 1000.0 * quantile(distance, 0.5)
            << ", 95 % " << 1000.0 * quantile(distance, 0.95) << " mm" << std::endl;
  EXPECT_LE(quantile(angle, 0.5), 0.1);
  EXPECT_LE(quantile(angle, 0.95), 1.8);
  EXPECT_LE(quantile(distance, 0.5), 0.0004);
  EXPECT_LE(quantile(distance, 0.95), 0.0017);
}

TEST_F(SimulatedQuality, ofCovariances) {
  const std::vector<double>& nees = errors().nees;
  ASSERT_FALSE(nees.empty());
  const auto within = std::count_if(nees.begin(), nees.end(), [](double n) { return n <= kChiSquared95; });
  const double fraction = static_cast<double>(within) / static_cast<double>(nees.size());
  std::cout << "normalised error squared: " << 100.0 * fraction << " % within the bound for 95 %, median "
            << quantile(nees, 0.5) << " (chi-squared: " << kChiSquaredMedian << ")" << std::endl;
  EXPECT_GE(fraction, 0.94);
  EXPECT_GE(quantile(nees, 0.5), 1.0) << "a large fraction is meaningless if all covariances are too large";
  EXPECT_GE(quantile(seen().as_recorded.nees, 0.5), 1.0);
}

}  // namespace
}  // namespace line_plane_segmentation
