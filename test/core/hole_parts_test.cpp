// SPDX-License-Identifier: BSD-3-Clause
#include "line_plane_segmentation/segmentation.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"

namespace line_plane_segmentation {
namespace {

/// A plane at z = 1, of squares.
class Squares {
 public:
  explicit Squares(const Eigen::Vector3d& normal = -Eigen::Vector3d::UnitZ()) {
    segmentation_.planes.resize(1);
    plane().normal = normal;
  }

  void addPart(float x, float y, float side) { addRing(x, y, side), ++plane().outer_ring_count; }
  void addHole(float x, float y, float side) { addRing(x, y, side), ++plane().hole_count; }
  std::vector<int> parts() const { return partsOfHoles(segmentation_, segmentation_.planes.front()); }

 private:
  SegmentedPlane& plane() { return segmentation_.planes.front(); }

  void addRing(float x, float y, float side) {
    segmentation_.rings.push_back({static_cast<int>(segmentation_.vertices.size()), 4});
    for (const auto& [u, v] : {std::pair(x, y), {x + side, y}, {x + side, y + side}, {x, y + side}}) {
      int axis = 0;
      plane().normal.cwiseAbs().maxCoeff(&axis);
      Eigen::Vector3f vertex = Eigen::Vector3f::Ones();
      vertex[(axis + 1) % 3] = u;
      vertex[(axis + 2) % 3] = v;
      segmentation_.vertices.push_back(vertex);
    }
  }

  Segmentation segmentation_;
};

TEST(PartsOfHoles, AreTheOnesAroundThem) {
  for (const Eigen::Vector3d& normal :
       {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(-1, 0, 0)}) {
    Squares plane(normal);
    plane.addPart(0, 0, 10);
    plane.addPart(20, 0, 5);
    plane.addPart(30, 0, 4);
    plane.addHole(31, 1, 1);
    plane.addHole(1, 1, 2);
    plane.addHole(21, 1, 2);
    plane.addHole(5, 5, 1);
    EXPECT_EQ((std::vector<int>{2, 0, 1, 0}), plane.parts());
  }
}

TEST(PartsOfHoles, InAPartWithinTheHoleOfAnother) {
  Squares plane;
  plane.addPart(0, 0, 10);
  plane.addPart(3, 3, 4);
  plane.addHole(2, 2, 6);
  plane.addHole(4, 4, 1);
  EXPECT_EQ((std::vector<int>{0, 1}), plane.parts());
}

TEST(PartsOfHoles, WithMostOfTheirVerticesInside) {
  Squares plane;
  plane.addPart(0, 0, 10);
  plane.addPart(20, 0, 5);
  plane.addHole(19.5F, 1, 2);  // two of four vertices are outside
  plane.addHole(50, 50, 1);
  EXPECT_EQ((std::vector<int>{0, 0}), plane.parts());
}

TEST(PartsOfHoles, OfASegmentedImage) {
  // A wall that a pole parts, with a hole in the smaller part.
  const int width = 320, height = 240;
  const CameraIntrinsics camera{262.5, 262.5, 159.5, 119.5};
  std::vector<std::uint16_t> depth(static_cast<std::size_t>(width) * height, 2000);
  const auto set = [&](int u0, int u1, int v0, int v1, std::uint16_t z) {
    for (int v = v0; v < v1; ++v) {
      for (int u = u0; u < u1; ++u) depth[static_cast<std::size_t>(v * width + u)] = z;
    }
  };
  set(200, 215, 0, height, 1000);
  set(250, 280, 100, 130, 0);
  set(60, 100, 60, 100, 0);
  PlaneSegmenter segmenter;
  const Segmentation& found = segmenter.segment(viewOf(depth.data(), width, height), camera);
  ASSERT_FALSE(found.planes.empty());
  const SegmentedPlane& wall = found.planes.front();
  ASSERT_EQ(2, wall.outer_ring_count);
  ASSERT_EQ(2, wall.hole_count);
  const std::vector<int> parts = partsOfHoles(found, wall);
  for (int h = 0; h < 2; ++h) {
    const Ring& hole = found.rings[static_cast<std::size_t>(wall.first_ring + 2 + h)];
    const bool is_right = found.vertices[static_cast<std::size_t>(hole.first_vertex)].x() > 0.3F;
    EXPECT_EQ(is_right ? 1 : 0, parts[static_cast<std::size_t>(h)]);
  }
}

}  // namespace
}  // namespace line_plane_segmentation
