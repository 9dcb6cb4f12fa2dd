// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "core/outline_checks.h"
#include "core/outline_images.h"
#include "core/outline_reference.h"
#include "outline/outline.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

/// Points that touching borders are drawn in by, in u and v [px], and the way that makes along the diagonal.
constexpr double kInset = 0.125, kInsetDistance = 0.18;

class OutlineFuzzTest : public testing::TestWithParam<OutlinePicture> {
 protected:
  /// Traces picture `seed` of the kind with parameters that vary with the seed.
  void trace(std::uint64_t seed, int largest_side) {
    Random random(seed);
    const int width = random.integer(2, largest_side), height = random.integer(2, largest_side);
    segmentation_ = outlinePicture(GetParam(), width, height, seed);
    camera_ = outlineCamera(width, height);
    constexpr double kTolerances[] = {0.0, 0.5, 1.0, 2.0, 2.0, 4.0, 10.0, 20.0};
    constexpr int kMinHoles[] = {0, 2, 10, 100};
    parameters_.outline_tolerance = kTolerances[random.integer(0, 7)];
    parameters_.min_hole_pixels = kMinHoles[random.integer(0, 3)];
    tracer_.trace(camera_, parameters_, segmentation_);
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_EQ(faultOf(segmentation_), "");
  }

  std::string caseOf(std::uint64_t seed, std::size_t k) const {
    return "seed " + std::to_string(seed) + ", plane " + std::to_string(k + 1) + ", tolerance " +
           std::to_string(parameters_.outline_tolerance) + ", holes from " +
           std::to_string(parameters_.min_hole_pixels);
  }

  OutlineTracer tracer_;
  CameraIntrinsics camera_;
  OutlineParameters parameters_;
  Segmentation segmentation_;
};

TEST_P(OutlineFuzzTest, RingsAreSimpleApartAndTurnTheRightWay) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    ASSERT_NO_FATAL_FAILURE(trace(seed, 56));
    for (std::size_t k = 0; k < segmentation_.planes.size(); ++k) {
      const SegmentedPlane& plane = segmentation_.planes[k];
      SCOPED_TRACE(caseOf(seed, k));
      const std::vector<Polygon> rings = ringsOnPlane(segmentation_, plane);
      ASSERT_EQ(faultOf(rings), "");
      for (std::size_t r = 0; r < rings.size(); ++r) {
        const bool is_outer = static_cast<int>(r) < plane.outer_ring_count;
        ASSERT_EQ(signedArea(rings[r]) > 0.0, is_outer) << "ring " << r;
      }
    }
  }
}

TEST_P(OutlineFuzzTest, RingsEncloseWhatPixelByPixelSearchFinds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    ASSERT_NO_FATAL_FAILURE(trace(seed, 32));
    for (std::size_t k = 0; k < segmentation_.planes.size(); ++k) {
      const SegmentedPlane& plane = segmentation_.planes[k];
      SCOPED_TRACE(caseOf(seed, k));
      const int label = static_cast<int>(k) + 1;
      const ReferenceOutline reference = referenceOutline(segmentation_, label, parameters_.min_hole_pixels);
      ASSERT_EQ(static_cast<std::size_t>(plane.outer_ring_count), reference.part_areas.size());
      ASSERT_EQ(static_cast<std::size_t>(plane.hole_count), reference.hole_areas.size());
      const std::vector<Polygon> rings = ringsInImage(segmentation_, plane, camera_);
      const double margin = parameters_.outline_tolerance + kInsetDistance;
      for (int v = 0; v < segmentation_.height; ++v) {
        for (int u = 0; u < segmentation_.width; ++u) {
          if (distanceToBorder(segmentation_, label, u, v) <= margin) continue;
          const bool expected = reference.inside[static_cast<std::size_t>(v * segmentation_.width + u)] != 0;
          ASSERT_EQ(isInside(rings, Eigen::Vector2d(u, v)), expected) << "pixel " << u << " " << v;
        }
      }
    }
  }
}

TEST_P(OutlineFuzzTest, WithoutToleranceAreasArePixelCounts) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    ASSERT_NO_FATAL_FAILURE(trace(seed, 32));
    parameters_.outline_tolerance = 0.0;
    tracer_.trace(camera_, parameters_, segmentation_);
    for (std::size_t k = 0; k < segmentation_.planes.size(); ++k) {
      const SegmentedPlane& plane = segmentation_.planes[k];
      SCOPED_TRACE(caseOf(seed, k));
      const ReferenceOutline reference =
          referenceOutline(segmentation_, static_cast<int>(k) + 1, parameters_.min_hole_pixels);
      std::vector<double> expected = reference.part_areas;
      for (const double hole : reference.hole_areas) expected.push_back(-hole);
      const std::vector<Polygon> rings = ringsInImage(segmentation_, plane, camera_);
      ASSERT_EQ(rings.size(), expected.size());
      for (std::size_t r = 0; r < rings.size(); ++r) {
        const auto vertices = static_cast<double>(rings[r].size());
        // Counterclockwise over the picture, where v goes down.
        const double area = -signedArea(rings[r]);
        if (!reference.has_touching_corners) {
          ASSERT_NEAR(area, expected[r], 1e-3 * vertices);
        } else {
          // A point that is drawn in moves the two edges at it, each as long as the image at most.
          const double most = kInset * (segmentation_.width + segmentation_.height) * vertices;
          ASSERT_NEAR(area, expected[r], most);
        }
      }
    }
  }
}

TEST_P(OutlineFuzzTest, BordersStayWithinTheTolerance) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    ASSERT_NO_FATAL_FAILURE(trace(seed, 56));
    const Segmentation simplified = segmentation_;
    const double tolerance = parameters_.outline_tolerance;
    parameters_.outline_tolerance = 0.0;
    tracer_.trace(camera_, parameters_, segmentation_);
    ASSERT_LE(simplified.vertices.size(), segmentation_.vertices.size());
    for (std::size_t k = 0; k < segmentation_.planes.size(); ++k) {
      SCOPED_TRACE(caseOf(seed, k));
      const std::vector<Polygon> borders = ringsInImage(segmentation_, segmentation_.planes[k], camera_);
      const std::vector<Polygon> rings = ringsInImage(simplified, simplified.planes[k], camera_);
      ASSERT_EQ(rings.size(), borders.size());
      for (std::size_t r = 0; r < rings.size(); ++r) {
        for (const Eigen::Vector2d& corner : borders[r]) {
          ASSERT_LE(distanceToRing(rings[r], corner), tolerance + 2.0 * kInsetDistance + 1e-3)
              << "of " << tolerance;
        }
      }
    }
  }
}

/// Parts runs at random: neighbours in a row then have the same label.
LabelRuns partedRuns(const LabelRuns& whole, Random& random) {
  LabelRuns parted;
  parted.clear();
  for (std::size_t row = 0; row + 1 < whole.row_begin.size(); ++row) {
    for (std::size_t i = whole.row_begin[row]; i < whole.row_begin[row + 1]; ++i) {
      LabelRun rest = whole.runs[i];
      while (rest.pixels() > 1 && random.chance(0.6)) {
        LabelRun part = rest;
        part.last = rest.first = random.integer(rest.first + 1, rest.last - 1);
        parted.runs.push_back(part);
      }
      parted.runs.push_back(rest);
    }
    parted.row_begin.push_back(parted.runs.size());
  }
  return parted;
}

TEST_P(OutlineFuzzTest, AreTheSameFromTheRunsOfTheLabels) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    ASSERT_NO_FATAL_FAILURE(trace(seed, 56));
    Random random(seed);
    LabelRuns whole;
    whole.scan(segmentation_.labels, segmentation_.width, segmentation_.height);
    Segmentation from_runs = segmentation_;
    tracer_.trace(camera_, parameters_, partedRuns(whole, random), from_runs);
    ASSERT_EQ(from_runs.vertices, segmentation_.vertices) << seed;
    ASSERT_EQ(from_runs.rings.size(), segmentation_.rings.size()) << seed;
    for (std::size_t i = 0; i < from_runs.rings.size(); ++i) {
      ASSERT_EQ(from_runs.rings[i].first_vertex, segmentation_.rings[i].first_vertex) << seed;
      ASSERT_EQ(from_runs.rings[i].vertex_count, segmentation_.rings[i].vertex_count) << seed;
    }
    for (std::size_t k = 0; k < from_runs.planes.size(); ++k) {
      const SegmentedPlane &plane = from_runs.planes[k], &expected = segmentation_.planes[k];
      ASSERT_EQ(plane.first_ring, expected.first_ring) << caseOf(seed, k);
      ASSERT_EQ(plane.outer_ring_count, expected.outer_ring_count) << caseOf(seed, k);
      ASSERT_EQ(plane.hole_count, expected.hole_count) << caseOf(seed, k);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pictures, OutlineFuzzTest, testing::ValuesIn(kAllOutlinePictures),
                         [](const auto& picture) { return nameOf(picture.param); });

}  // namespace
}  // namespace line_plane_segmentation
