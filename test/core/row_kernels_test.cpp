// SPDX-License-Identifier: BSD-3-Clause
// Each kernel twice: against what its comment says, and against itself compiled without vectors, bit by bit.
#include "kernels/row_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "planes/inverse_depth_plane.h"
#include "refine/label_runs.h"
#include "scalar_kernels.h"
#include "support/random.h"

namespace line_plane_segmentation {
namespace {

namespace scalar = ::scalar_twin::line_plane_segmentation;

constexpr int kMaxCount = 150;
constexpr std::uint8_t kUntouched = 0xEE;

/// A row of pixels that starts at any address, with everything that the kernels read.
struct Row {
  int count;
  float y, y_below, a, b, d;
  std::vector<float> z_, below_, x_;

  explicit Row(Random& random) : count(random.integer(1, kMaxCount)) {
    const int offset = random.integer(0, 7);
    const float distance = static_cast<float>(random.uniform(0.5, 4.0));
    const auto depth = [&] {
      return random.chance(0.15) ? 0.0F : distance + static_cast<float>(random.uniform(-0.04, 0.04));
    };
    for (int i = 0; i < offset + count; ++i) {
      z_.push_back(depth());
      below_.push_back(depth());
      x_.push_back(-0.5F + static_cast<float>(i) / 525.0F);
    }
    z_.erase(z_.begin(), z_.begin() + offset);
    y = static_cast<float>(random.uniform(-0.4, 0.4));
    y_below = y + 1.0F / 525.0F;
    b = static_cast<float>(random.uniform(-0.2, 0.2));
    a = -std::sqrt(1.0F - b * b);
    d = -distance * (a - 0.4F * b);
  }

  const float* z() const { return z_.data(); }
  const float* x() const { return x_.data(); }
  const float* below() const { return below_.data(); }
  double depth(int i) const { return z_[static_cast<std::size_t>(i)]; }
  Eigen::Vector3d point(int i) const {
    return depth(i) * Eigen::Vector3d(x_[static_cast<std::size_t>(i)], y, 1.0);
  }
  Eigen::Vector3d pointBelow(int i) const {
    return below_[static_cast<std::size_t>(i)] *
           Eigen::Vector3d(x_[static_cast<std::size_t>(i)], y_below, 1.0);
  }
};

/// Room for results, with marks behind their end.
template <typename T>
std::vector<T> results(int count) {
  return std::vector<T>(static_cast<std::size_t>(count) + 8, static_cast<T>(kUntouched));
}

template <typename T>
void expectSameBits(const std::vector<T>& vector, const std::vector<T>& one_by_one, int count) {
  ASSERT_EQ(std::memcmp(vector.data(), one_by_one.data(), vector.size() * sizeof(T)), 0);
  for (std::size_t i = static_cast<std::size_t>(count); i < vector.size(); ++i)
    ASSERT_EQ(vector[i], static_cast<T>(kUntouched));
}

class RowKernels : public testing::Test {
 protected:
  /// Calls `test(row)` for many rows.
  template <typename Test>
  void forManyRows(Test test) {
    for (int trial = 0; trial < 500 && !HasFatalFailure(); ++trial) test(Row(random_));
  }

  Random random_{1};
};

TEST_F(RowKernels, MarkAndCountInliers) {
  constexpr float kThreshold = 0.02F;
  int total = 0;
  forManyRows([&](const Row& row) {
    std::vector<std::uint8_t> mask = results<std::uint8_t>(row.count), twin = mask;
    markInliers(row.z(), row.x(), row.count, row.a, row.b, row.d, kThreshold, mask.data());
    scalar::markInliers(row.z(), row.x(), row.count, row.a, row.b, row.d, kThreshold, twin.data());
    expectSameBits(mask, twin, row.count);
    const Eigen::Vector3d normal(row.b, 0.0, row.a);  // a = ny y + nz, here with ny = 0
    int count = 0;
    for (int i = 0; i < row.count; ++i) {
      const double distance = std::abs(normal.dot(row.point(i)) + static_cast<double>(row.d));
      count += mask[static_cast<std::size_t>(i)];
      if (std::abs(distance - static_cast<double>(kThreshold)) < 1e-6) continue;  // rounding may decide
      ASSERT_EQ(mask[static_cast<std::size_t>(i)],
                row.depth(i) > 0.0 && distance < static_cast<double>(kThreshold) ? 1 : 0);
    }
    ASSERT_EQ(countInliers(row.z(), row.x(), row.count, row.a, row.b, row.d, kThreshold), count);
    ASSERT_EQ(scalar::countInliers(row.z(), row.x(), row.count, row.a, row.b, row.d, kThreshold), count);
    total += count;
  });
  EXPECT_GT(total, 1000);
}

TEST_F(RowKernels, LinkNeighbors) {
  constexpr float kBound = 0.03F * 0.03F;
  forManyRows([&](const Row& row) {
    for (const float* below : {row.below(), static_cast<const float*>(nullptr)}) {
      std::vector<std::uint8_t> links = results<std::uint8_t>(row.count), twin = links;
      linkNeighbors(row.z(), below, row.x(), row.y, row.y_below, row.count, kBound, links.data());
      scalar::linkNeighbors(row.z(), below, row.x(), row.y, row.y_below, row.count, kBound, twin.data());
      expectSameBits(links, twin, row.count);
      for (int i = 0; i < row.count; ++i) {
        const int bits = links[static_cast<std::size_t>(i)];
        const auto expect_bit = [&](int bit, bool exists, double squared) {
          if (std::abs(squared - static_cast<double>(kBound)) < 1e-8) return;
          ASSERT_EQ((bits & bit) != 0, exists && squared < static_cast<double>(kBound))
              << i << " of " << row.count;
        };
        const bool is_last = i + 1 == row.count;
        expect_bit(kLinkRight, !is_last && row.depth(i) > 0.0 && row.depth(i + (is_last ? 0 : 1)) > 0.0,
                   is_last ? 0.0 : (row.point(i + 1) - row.point(i)).squaredNorm());
        expect_bit(kLinkDown, below != nullptr && row.depth(i) > 0.0 && row.below()[i] > 0.0F,
                   (row.pointBelow(i) - row.point(i)).squaredNorm());
        ASSERT_EQ(bits & ~(kLinkRight | kLinkDown), 0);
      }
    }
  });
}

TEST_F(RowKernels, MarkRunBoundaries) {
  forManyRows([&](const Row& row) {
    std::vector<std::uint8_t> mask, links;
    for (int i = 0; i < row.count; ++i) {
      mask.push_back(random_.chance(0.8) ? 1 : 0);
      links.push_back(static_cast<std::uint8_t>(random_.integer(0, 3)));
    }
    std::vector<std::uint8_t> boundaries = results<std::uint8_t>(row.count), twin = boundaries;
    markRunBoundaries(mask.data(), links.data(), row.count, boundaries.data());
    scalar::markRunBoundaries(mask.data(), links.data(), row.count, twin.data());
    expectSameBits(boundaries, twin, row.count);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const bool was_set = i > 0 && mask[i - 1] != 0, is_set = mask[i] != 0;
      const bool is_linked = i > 0 && (links[i - 1] & kLinkRight) != 0;
      ASSERT_EQ(boundaries[i] != 0, was_set != is_set || (was_set && is_set && !is_linked)) << i;
    }
  });
}

TEST_F(RowKernels, MarkChanges) {
  forManyRows([&](const Row& row) {
    std::vector<std::uint16_t> labels;
    for (int i = 0; i < row.count; ++i) {
      const bool stays = i > 0 && random_.chance(0.7);
      labels.push_back(
          stays ? labels.back()
                : static_cast<std::uint16_t>(random_.chance(0.2) ? kNoDepthLabel : random_.integer(0, 300)));
    }
    std::vector<std::uint8_t> changes = results<std::uint8_t>(row.count), twin = changes;
    markChanges(labels.data(), row.count, changes.data());
    scalar::markChanges(labels.data(), row.count, twin.data());
    expectSameBits(changes, twin, row.count);
    ASSERT_EQ(changes[0], 0);
    for (std::size_t i = 1; i < labels.size(); ++i) ASSERT_EQ(changes[i], labels[i] != labels[i - 1] ? 1 : 0);
  });
}

TEST_F(RowKernels, AppendMarked) {
  forManyRows([&](const Row& row) {
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(row.count) + kMarkBlock, 0);
    const double fraction = random_.uniform(0.0, 1.0) * random_.uniform(0.0, 1.0);
    std::vector<int> expected = {-1};  // what is there already stays
    for (int i = 0; i < row.count; ++i) {
      marks[static_cast<std::size_t>(i)] = random_.chance(fraction) ? 1 : 0;
      if (marks[static_cast<std::size_t>(i)] != 0) expected.push_back(i);
    }
    for (const auto append : {compactIndices, scalar::compactIndices}) {
      std::vector<int> columns(expected.size() + kSpareColumns, -1);
      const int* const end = append(marks.data(), row.count, columns.data() + 1);
      ASSERT_EQ(end - columns.data(), static_cast<std::ptrdiff_t>(expected.size()));
      columns.resize(expected.size());
      ASSERT_EQ(columns, expected);
    }
  });
}

TEST_F(RowKernels, PrepareAndAssign) {
  const NoiseParameters noise;
  const double factor = 3.0, distance = 0.01;
  const DepthTolerance tolerance{noise, factor, distance};
  const RowNoise row_noise{static_cast<float>(factor * noise.floor),
                           static_cast<float>(factor * noise.growth), static_cast<float>(noise.nearest)};
  forManyRows([&](const Row& row) {
    std::vector<float> reach = results<float>(row.count), best = reach, twin_reach = reach, twin_best = reach;
    std::vector<std::uint16_t> label = results<std::uint16_t>(row.count), twin_label = label;
    prepareRow(row.z(), row.count, row_noise, reach.data(), best.data(), label.data());
    scalar::prepareRow(row.z(), row.count, row_noise, twin_reach.data(), twin_best.data(), twin_label.data());
    expectSameBits(best, twin_best, row.count);
    expectSameBits(label, twin_label, row.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const double z = row.depth(static_cast<int>(i));
      ASSERT_EQ(label[i], z > 0.0 ? 0 : kNoDepthLabel);
      ASSERT_EQ(best[i], z > 0.0 ? 1.0F : 0.0F);
      if (!(z > 0.0)) continue;
      ASSERT_EQ(std::memcmp(&reach[i], &twin_reach[i], sizeof(float)), 0);
      ASSERT_NEAR(static_cast<double>(reach[i]) * z * tolerance.along(1.0 / z), 1.0, 1e-4);
    }

    // Two planes, one after the other: the row's own, and one that it is tilted against.
    for (const std::uint16_t plane_label : {std::uint16_t{7}, std::uint16_t{9}}) {
      const float tilt = plane_label == 7 ? 0.0F : 0.05F;
      const RowOfPlane plane{-row.b / row.d + tilt, -row.a / row.d + 0.1F * tilt,
                             row.d / static_cast<float>(distance), plane_label};
      const std::vector<float> best_before = best;
      const std::vector<std::uint16_t> label_before = label;
      assignIfBetter(row.z(), reach.data(), row.x(), row.count, plane, best.data(), label.data());
      scalar::assignIfBetter(row.z(), twin_reach.data(), row.x(), row.count, plane, twin_best.data(),
                             twin_label.data());
      expectSameBits(best, twin_best, row.count);
      expectSameBits(label, twin_label, row.count);
      for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        if (label_before[i] == kNoDepthLabel) {
          ASSERT_EQ(label[i], kNoDepthLabel);
          continue;
        }
        const double w = 1.0 / row.depth(static_cast<int>(i));
        const double expected = static_cast<double>(plane.slope) * static_cast<double>(row.x()[i]) +
                                static_cast<double>(plane.offset);
        const double error = std::abs(w - expected) / tolerance.at(w, 1.0 / static_cast<double>(row.d));
        if (std::abs(error - static_cast<double>(best_before[i])) < 1e-3) continue;  // rounding may decide
        const bool is_better = error < static_cast<double>(best_before[i]);
        ASSERT_EQ(label[i], is_better ? plane_label : label_before[i]);
        ASSERT_NEAR(static_cast<double>(best[i]), is_better ? error : static_cast<double>(best_before[i]),
                    1e-3);
      }
    }
  });
}

double total(const PixelSums::Lanes& lanes) { return lanes[0] + lanes[1] + lanes[2] + lanes[3]; }

TEST_F(RowKernels, AddRun) {
  PixelSums sums, twin;
  std::array<double, 10> expected{};
  double pixels = 0.0;
  forManyRows([&](const Row& row) {
    // Of memory of their own, so that the address sanitizer sees what is read beside the run.
    const std::vector<float> z(row.z(), row.z() + row.count);
    const std::vector<double> x(row.x(), row.x() + row.count);
    const double y = static_cast<double>(row.y);
    addRun(z.data(), x.data(), y, row.count, sums);
    scalar::addRun(z.data(), x.data(), y, row.count, twin);
    ASSERT_EQ(std::memcmp(&sums, &twin, sizeof sums), 0);
    pixels += row.count;
    for (int i = 0; i < row.count; ++i) {
      const Eigen::Vector3d p = row.point(i);
      const std::array<double, 10> of_pixel = {
          p.z(),         p.x(),         p.y(),         p.z() * p.z(), p.z() * p.x(),
          p.z() * p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.z() * p.z() * p.z()};
      for (std::size_t k = 0; k < expected.size(); ++k) expected[k] += of_pixel[k];
    }
  });
  EXPECT_EQ(sums.pixels, pixels);
  const std::array<double, 10> totals = {
      total(sums.z),   total(sums.zx),   total(sums.zy),   total(sums.zz),   total(sums.zzx),
      total(sums.zzy), total(sums.zzxx), total(sums.zzxy), total(sums.zzyy), total(sums.zzz)};
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(totals[k], expected[k], 1e-9 * (1.0 + std::abs(expected[k]))) << k;
}

}  // namespace
}  // namespace line_plane_segmentation
