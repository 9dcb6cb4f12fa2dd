// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "support/random.h"

namespace line_plane_segmentation {

/// Regular pictures that make work for one stage or another: thin holes, thin surfaces, many small surfaces.
enum class PatternKind {
  kSpiral,        ///< a spiral of holes, whose border is as long as can be
  kSquareSpiral,  ///< the same along rows and columns
  kRowComb,       ///< rows without depth, joined at one side
  kColumnComb,    ///< columns without depth, joined at one side
  kDots,          ///< a grid of holes
  kSpeckle,       ///< pixels without depth at random
  kCarpet,        ///< holes of all sizes: Sierpinski's carpet
  kChecker,       ///< squares in two depths
  kStripes,       ///< stripes in two depths
  kRidges,        ///< roofs side by side
  kPyramids,      ///< pyramids side by side
  kStairs,        ///< small squares in many depths
  kWaves,         ///< a smooth surface without planes
  kNoise,         ///< depth at random
};
constexpr int kPatternKinds = static_cast<int>(PatternKind::kNoise) + 1;

struct Pattern {
  PatternKind kind = PatternKind::kSpiral;
  int pitch = 3;   ///< [px] from one of its parts to the next, at least 2
  int part = 1;    ///< [px] of the pitch that are a hole or at the other depth, at least 1
  int step = 100;  ///< [mm] between its depths
  int slope = 0;   ///< [mm/px] of the surface that it is drawn on, to the right

  /// "spiral, pitch 3 px, part 1 px, step 100 mm, slope 0 mm/px"
  std::string name() const;
};

Pattern randomPattern(Random& random);

/// A pattern with one or two values changed.
Pattern changedPattern(const Pattern& pattern, Random& random);

/// A method, and how long it takes.
class SlowImages {
 public:
  static constexpr int kWidth = 640, kHeight = 480;

  explicit SlowImages(const Parameters& parameters);

  /// [mm] kWidth * kHeight pixels, 0 = no depth
  static std::vector<std::uint16_t> draw(const Pattern& pattern);

  /// [s] of processor time, the least of several runs
  double secondsOf(const std::vector<std::uint16_t>& depth, int runs);

  /// The median time over that of simulated rooms. An image and a room take turns, so that a machine that
  /// changes its speed changes both.
  double timesOfRoom(const std::vector<std::uint16_t>& depth, int runs);

  /// [s] the median of simulated rooms
  double secondsOfRoom();

 private:
  PlaneSegmenter segmenter_;
  std::vector<std::vector<std::uint16_t>> rooms_;
};

}  // namespace line_plane_segmentation
