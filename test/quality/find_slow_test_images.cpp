// SPDX-License-Identifier: BSD-3-Clause
// Searches for pictures that take the segmenter long: random patterns, of which the slowest are changed
// again and again. Run by scripts/find_slow_images.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "quality/slow_images.h"

namespace line_plane_segmentation {
namespace {

constexpr int kKeptOfKind = 2;
constexpr int kRuns = 3, kFinalRuns = 2;

struct Tried {
  double seconds;
  Pattern pattern;
};

void keepSlowestOfEachKind(std::vector<Tried>& slowest) {
  std::sort(slowest.begin(), slowest.end(),
            [](const Tried& a, const Tried& b) { return a.seconds > b.seconds; });
  std::array<int, kPatternKinds> kept{};
  const auto is_more = [&kept](const Tried& tried) {
    return ++kept[static_cast<std::size_t>(tried.pattern.kind)] > kKeptOfKind;
  };
  slowest.erase(std::remove_if(slowest.begin(), slowest.end(), is_more), slowest.end());
}

void search(SlowImages& images, double seconds, std::vector<Tried>& slowest) {
  Random random(1);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    const bool is_new = slowest.empty() || random.chance(0.3);
    const int last = static_cast<int>(slowest.size()) - 1;
    const Pattern pattern =
        is_new ? randomPattern(random) : changedPattern(slowest[random.integer(0, last)].pattern, random);
    const double time = images.secondsOf(SlowImages::draw(pattern), kRuns);
    slowest.push_back({time, pattern});
    keepSlowestOfEachKind(slowest);
  }
}

int run(const std::string& preset, double seconds) {
  Parameters parameters;
  if (!loadPreset(preset, parameters)) {
    std::cerr << "find_slow_test_images: there is no preset " << preset << '\n';
    return 1;
  }
  SlowImages images(parameters);
  std::vector<Tried> slowest;
  search(images, seconds, slowest);
  std::cout << std::fixed << std::setprecision(2) << preset << ": a room takes "
            << 1e3 * images.secondsOfRoom() << " ms\n";
  for (const Tried& tried : slowest) {
    const double times = images.timesOfRoom(SlowImages::draw(tried.pattern), kFinalRuns);
    std::cout << "  " << times << " times: " << tried.pattern.name() << '\n';
  }
  return 0;
}

}  // namespace
}  // namespace line_plane_segmentation

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "Usage: find_slow_test_images PRESET SECONDS\n";
    return 1;
  }
  return line_plane_segmentation::run(argv[1], std::atof(argv[2]));
}
