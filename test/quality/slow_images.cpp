// SPDX-License-Identifier: BSD-3-Clause
#include "quality/slow_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "simulated_camera.h"
#include "support/median.h"

namespace line_plane_segmentation {
namespace {

constexpr int kDepth = 1500;  // [mm] of the surface that a pattern is drawn on
constexpr std::uint64_t kRooms = 9;

constexpr std::array<const char*, kPatternKinds> kNames = {
    "spiral",  "square spiral", "row comb", "column comb", "dots",   "speckle", "carpet",
    "checker", "stripes",       "ridges",   "pyramids",    "stairs", "waves",   "noise"};

double wrapped(double value, double period) { return value - std::floor(value / period) * period; }

bool isHoleOfSpiral(const Pattern& p, int u, int v) {
  const double x = u - SlowImages::kWidth / 2, y = v - SlowImages::kHeight / 2;
  return wrapped(std::hypot(x, y) - p.pitch * std::atan2(y, x) / (2.0 * M_PI), p.pitch) < p.part;
}

// Rings of holes, each left open where the next one is joined to it.
bool isHoleOfSquareSpiral(const Pattern& p, int u, int v) {
  const int x = u - SlowImages::kWidth / 2, y = v - SlowImages::kHeight / 2;
  const int ring = std::max(std::abs(x), std::abs(y));
  const bool is_gap = y == -ring && x > ring - p.pitch;
  return ring % p.pitch < p.part && !is_gap;
}

bool isHoleOfCarpet(const Pattern& p, int u, int v) {
  for (int x = u / p.part, y = v / p.part; x > 0 || y > 0; x /= 3, y /= 3) {
    if (x % 3 == 1 && y % 3 == 1) return true;
  }
  return false;
}

// A tent of the pitch's length, from 0 to half of the pitch and back.
int tent(const Pattern& p, int at) { return std::abs(at % (2 * p.pitch) - p.pitch); }

bool isHole(const Pattern& p, int u, int v, Random& random) {
  const bool in_column = u % p.pitch < p.part, in_row = v % p.pitch < p.part;
  switch (p.kind) {
    case PatternKind::kSpiral:
      return isHoleOfSpiral(p, u, v);
    case PatternKind::kSquareSpiral:
      return isHoleOfSquareSpiral(p, u, v);
    case PatternKind::kRowComb:
      return in_row && u >= p.pitch;
    case PatternKind::kColumnComb:
      return in_column && v >= p.pitch;
    case PatternKind::kDots:
      return in_row && in_column;
    case PatternKind::kSpeckle:
      return random.chance(static_cast<double>(p.part) / p.pitch);
    case PatternKind::kCarpet:
      return isHoleOfCarpet(p, u, v);
    default:
      return false;
  }
}

double depthAbove(const Pattern& p, int u, int v, Random& random) {
  const double step = p.step;
  switch (p.kind) {
    case PatternKind::kChecker:
      return (u / p.pitch + v / p.pitch) % 2 * step;
    case PatternKind::kStripes:
      return u % p.pitch < p.part ? step : 0.0;
    case PatternKind::kRidges:
      return tent(p, u) * step / p.pitch;
    case PatternKind::kPyramids:
      return std::max(tent(p, u), tent(p, v)) * step / p.pitch;
    case PatternKind::kStairs:
      return (u / p.pitch + 3 * (v / p.pitch)) % 50 * 0.2 * step;
    case PatternKind::kWaves:
      return step * std::sin(u / (5.0 * p.pitch)) * std::sin(v / (5.0 * p.pitch));
    case PatternKind::kNoise:
      return random.integer(0, 10 * p.step);
    default:
      return 0.0;
  }
}

}  // namespace

std::string Pattern::name() const {
  return std::string(kNames[static_cast<std::size_t>(kind)]) + ", pitch " + std::to_string(pitch) +
         " px, part " + std::to_string(part) + " px, step " + std::to_string(step) + " mm, slope " +
         std::to_string(slope) + " mm/px";
}

Pattern randomPattern(Random& random) {
  Pattern pattern;
  pattern.kind = static_cast<PatternKind>(random.integer(0, kPatternKinds - 1));
  pattern.pitch = random.integer(2, 32);
  pattern.part = random.integer(1, pattern.pitch - 1);
  pattern.step = random.integer(5, 300);
  pattern.slope = random.integer(0, 3);
  return pattern;
}

Pattern changedPattern(const Pattern& pattern, Random& random) {
  Pattern changed = pattern;
  for (int changes = random.integer(1, 2); changes > 0; --changes) {
    const Pattern other = randomPattern(random);
    switch (random.integer(0, 4)) {
      case 0:
        changed.kind = other.kind;
        break;
      case 1:
        changed.pitch = std::max(2, pattern.pitch + random.integer(-2, 2));
        break;
      case 2:
        changed.part = pattern.part + random.integer(-1, 1);
        break;
      case 3:
        changed.step = other.step;
        break;
      default:
        changed.slope = other.slope;
        break;
    }
  }
  changed.part = std::clamp(changed.part, 1, changed.pitch - 1);
  return changed;
}

SlowImages::SlowImages(const Parameters& parameters) : segmenter_(parameters) {
  for (std::uint64_t room = 1; room <= kRooms; ++room) {
    simulation::SimulatedCamera camera({room, kWidth, kHeight, true});
    rooms_.emplace_back(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(kHeight));
    camera.capture(0, 5.0, rooms_.back().data());
  }
}

std::vector<std::uint16_t> SlowImages::draw(const Pattern& pattern) {
  Random random(1);
  std::vector<std::uint16_t> depth;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double z = kDepth + pattern.slope * u + depthAbove(pattern, u, v, random);
      depth.push_back(isHole(pattern, u, v, random) ? std::uint16_t{0} : static_cast<std::uint16_t>(z));
    }
  }
  return depth;
}

double SlowImages::secondsOf(const std::vector<std::uint16_t>& depth, int runs) {
  const CameraIntrinsics camera = simulation::kinectIntrinsics(kWidth, kHeight);
  double least = std::numeric_limits<double>::max();
  for (int run = 0; run < runs; ++run) {
    const std::clock_t start = std::clock();
    segmenter_.segment(viewOf(depth.data(), kWidth, kHeight), camera);
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

double SlowImages::timesOfRoom(const std::vector<std::uint16_t>& depth, int runs) {
  std::vector<double> of_image, of_rooms;
  for (int run = 0; run < runs; ++run) {
    for (const std::vector<std::uint16_t>& room : rooms_) {
      of_rooms.push_back(secondsOf(room, 1));
      of_image.push_back(secondsOf(depth, 1));
    }
  }
  return median(of_image) / median(of_rooms);
}

double SlowImages::secondsOfRoom() {
  std::vector<double> seconds;
  for (const std::vector<std::uint16_t>& room : rooms_) seconds.push_back(secondsOf(room, 3));
  return median(seconds);
}

}  // namespace line_plane_segmentation
