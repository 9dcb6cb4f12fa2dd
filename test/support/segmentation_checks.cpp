// SPDX-License-Identifier: BSD-3-Clause
#include "support/segmentation_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace line_plane_segmentation {
namespace {

template <typename T>
bool sameBits(const T* a, const T* b, std::size_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof(T)) == 0;
}

void expectPlaneIsSound(const SegmentedPlane& plane) {
  EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-9);
  EXPECT_GT(plane.d, 0.0);
  EXPECT_LT(plane.normal.dot(plane.centroid), 0.0) << "the normal looks at the camera";
  EXPECT_LE(std::abs(plane.normal.dot(plane.centroid) + plane.d), plane.rms + 1e-9) << "rms has that in it";
  EXPECT_TRUE(plane.centroid.allFinite());
  EXPECT_TRUE(plane.covariance.allFinite())
      << plane.covariance << "\nof " << plane.inliers << " pixels, d " << plane.d;
  EXPECT_TRUE(std::isfinite(plane.rms) && plane.rms >= 0.0) << plane.rms;
  EXPECT_TRUE(std::isfinite(plane.area) && plane.area > 0.0) << plane.area;
}

void expectRingsExist(const SegmentedPlane& plane, const Segmentation& segmentation) {
  ASSERT_GE(plane.first_ring, 0);
  ASSERT_LE(static_cast<std::size_t>(plane.first_ring + plane.outer_ring_count + plane.hole_count),
            segmentation.rings.size());
  for (int i = 0; i < plane.outer_ring_count + plane.hole_count; ++i) {
    const Ring& ring = segmentation.rings[static_cast<std::size_t>(plane.first_ring + i)];
    EXPECT_GE(ring.vertex_count, 3);
    ASSERT_LE(static_cast<std::size_t>(ring.first_vertex + ring.vertex_count), segmentation.vertices.size());
  }
}

}  // namespace

void expectConsistent(const Segmentation& segmentation, const DepthImage& depth) {
  ASSERT_EQ(segmentation.width, depth.width);
  ASSERT_EQ(segmentation.height, depth.height);
  ASSERT_EQ(segmentation.labels.size(), depth.z.size());
  std::vector<std::uint32_t> pixels(segmentation.planes.size() + 1, 0);
  std::uint32_t valid = 0;
  for (std::size_t i = 0; i < depth.z.size(); ++i) {
    const std::uint16_t label = segmentation.labels[i];
    ASSERT_LE(label, segmentation.planes.size());
    ASSERT_TRUE(label == 0 || depth.z[i] > 0.0F) << "a label where there is no depth";
    ++pixels[label];
    valid += depth.z[i] > 0.0F ? 1 : 0;
  }
  EXPECT_EQ(segmentation.valid_pixels, valid);
  EXPECT_EQ(segmentation.assigned_pixels, depth.z.size() - pixels[0]);
  for (std::size_t k = 1; k <= segmentation.planes.size(); ++k) {
    const SegmentedPlane& plane = segmentation.planes[k - 1];
    EXPECT_EQ(plane.label, k);
    EXPECT_EQ(plane.inliers, pixels[k]);
    EXPECT_GE(plane.inliers, 3U);
    expectPlaneIsSound(plane);
    expectRingsExist(plane, segmentation);
  }
  for (const Eigen::Vector3f& vertex : segmentation.vertices) EXPECT_TRUE(vertex.allFinite());
}

void expectSameBits(const Segmentation& a, const Segmentation& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.valid_pixels, b.valid_pixels);
  EXPECT_EQ(a.assigned_pixels, b.assigned_pixels);
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    const SegmentedPlane &p = a.planes[i], &q = b.planes[i];
    EXPECT_TRUE(sameBits(p.normal.data(), q.normal.data(), 3) && sameBits(&p.d, &q.d, 1) &&
                sameBits(p.centroid.data(), q.centroid.data(), 3) &&
                sameBits(p.covariance.data(), q.covariance.data(), 16) && sameBits(&p.rms, &q.rms, 1) &&
                sameBits(&p.area, &q.area, 1) && p.label == q.label && p.inliers == q.inliers &&
                p.first_ring == q.first_ring && p.outer_ring_count == q.outer_ring_count &&
                p.hole_count == q.hole_count)
        << "plane " << i + 1;
  }
  ASSERT_EQ(a.rings.size(), b.rings.size());
  EXPECT_TRUE(sameBits(a.rings.data(), b.rings.data(), a.rings.size()));
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_TRUE(sameBits(a.vertices.data(), b.vertices.data(), a.vertices.size()));
}

}  // namespace line_plane_segmentation
