// SPDX-License-Identifier: BSD-3-Clause
// Where the default of line_fidelity comes from, and what holds it: scans with the noise of Eq. 5, drawn for
// each pixel alone. Lower, it loses planes; higher, it passes what is bent: on the bounds below it fails
// either way.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lines/line_extraction.h"
#include "support/random.h"
#include "support/resolved_parameters.h"
#include "support/synthetic_scan.h"

namespace line_plane_segmentation {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr int kPixels = 200;
constexpr int kEdge = kPixels / 2;

/// Two straight pieces that meet in the middle of a scan, under an angle or with a step in depth.
struct Edge {
  double angle = 0.0;  ///< [rad]
  double step = 0.0;   ///< [m]
};

struct Fractions {
  double windows_passed =
      0.0;               ///< of the windows on a plane, or of those with points on both sides of an edge
  double covered = 0.0;  ///< of the points, by segments
  double crossed = 0.0;  ///< of the edges, by a segment with a window's length on both sides
};

Scanline randomScan(const Edge& edge, double distance, const ScanCamera& camera, Random& random) {
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  const double view = edge.angle > 1.2 ? random.uniform(-0.2, 0.2) : random.uniform(-0.7, 0.7);
  Scanline scan =
      scanOf(camera, {pieceThrough(camera, kEdge, distance, view - 0.5 * sign * edge.angle, 0, kEdge - 1),
                      pieceThrough(camera, kEdge, distance + sign * edge.step, view + 0.5 * sign * edge.angle,
                                   kEdge, kPixels - 1)});
  addNoise({}, 1.0, random, scan);
  return scan;
}

Fractions fractionsOf(const Edge& edge, double distance, int image_width, double line_fidelity,
                      bool quantized = false) {
  constexpr int kTrials = 300;
  const ScanCamera camera{525.0 * image_width / 640.0, kEdge - 0.5};
  LineParameters parameters = paperParameters(image_width).lines;
  parameters.line_fidelity = line_fidelity;
  const int window = parameters.line_window;
  const bool has_edge = edge.angle != 0.0 || edge.step != 0.0;
  const int first_window = has_edge ? kEdge - window + 1 : 0;
  const int last_window = has_edge ? kEdge - 1 : kPixels - window;

  Random random(7);
  LineExtractor extractor;
  std::vector<LineSegment> segments;
  Fractions fractions;
  for (int trial = 0; trial < kTrials; ++trial) {
    Scanline scan = randomScan(edge, distance, camera, random);
    if (quantized) quantize(scan);
    const std::vector<double>& fidelity = extractor.fidelity(scan.points.data(), kPixels, {}, parameters);
    for (int i = first_window; i <= last_window; ++i) {
      const double fraction = 1.0 / (last_window - first_window + 1) / kTrials;
      fractions.windows_passed += fidelity[static_cast<std::size_t>(i)] < line_fidelity ? fraction : 0.0;
    }
    segments.clear();
    extractor.extract(scan, {}, parameters, segments);
    std::vector<bool> covered(kPixels, false);
    bool crossed = false;
    for (const LineSegment& segment : segments) {
      std::fill(covered.begin() + segment.first, covered.begin() + segment.last + 1, true);
      crossed |= segment.first <= kEdge - window && segment.last >= kEdge + window - 1;
    }
    for (const bool c : covered) fractions.covered += c ? 1.0 / kPixels / kTrials : 0.0;
    fractions.crossed += crossed ? 1.0 / kTrials : 0.0;
  }
  return fractions;
}

constexpr double kDistances[] = {0.8, 1.2, 1.6, 2.0, 2.5};
const double kDefault = LineParameters{}.line_fidelity;

TEST(LineFidelity, PassesPlanes) {
  for (const double z : kDistances) {
    const Fractions vga = fractionsOf({}, z, 640, kDefault), qvga = fractionsOf({}, z, 320, kDefault);
    EXPECT_GT(vga.windows_passed, 0.83) << z;
    EXPECT_GT(vga.covered, 0.89) << z;
    EXPECT_GT(qvga.windows_passed, 0.74) << z;
    EXPECT_GT(qvga.covered, 0.86) << z;
  }
}

TEST(LineFidelity, PassesPlanesOfAQuantizingSensor) {
  for (const double z : {0.8, 1.2, 1.6}) {
    EXPECT_GT(fractionsOf({}, z, 640, kDefault, true).covered, 0.88) << z;
    EXPECT_GT(fractionsOf({}, z, 320, kDefault, true).covered, 0.75) << z;
  }
}

TEST(LineFidelity, IsNotPassedAcrossSteps) {
  for (const int width : {320, 640}) {
    for (const double z : kDistances) {
      const Fractions small = fractionsOf({0.0, 0.05}, z, width, kDefault);
      EXPECT_LT(small.windows_passed, z < 1.8 ? 0.01 : 0.2) << width << ' ' << z;
      EXPECT_LT(small.crossed, 0.02) << width << ' ' << z;
      for (const double step : {0.1, 0.2}) {
        const Fractions large = fractionsOf({0.0, step}, z, width, kDefault);
        EXPECT_LT(large.windows_passed, 0.01) << width << ' ' << z << ' ' << step;
        EXPECT_EQ(large.crossed, 0.0) << width << ' ' << z << ' ' << step;
      }
    }
  }
}

TEST(LineFidelity, CutsCreases) {
  for (const int width : {320, 640}) {
    for (const double z : kDistances) {
      EXPECT_LT(fractionsOf({90 * kDegree, 0.0}, z, width, kDefault).crossed, 0.005) << width << ' ' << z;
      EXPECT_LT(fractionsOf({60 * kDegree, 0.0}, z, width, kDefault).crossed, 0.06) << width << ' ' << z;
      EXPECT_LT(fractionsOf({30 * kDegree, 0.0}, z, width, kDefault).crossed, 0.30) << width << ' ' << z;
    }
  }
}

}  // namespace
}  // namespace line_plane_segmentation
