// SPDX-License-Identifier: BSD-3-Clause
// Depth images of simulated rooms with a Kinect's noise, as segment_test_rooms reads them.
// Usage: write_test_rooms COUNT WIDTH HEIGHT >FILE
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "simulation.h"

int main(int argc, char** argv) {
  using namespace line_plane_segmentation::simulation;
  if (argc != 4) return EXIT_FAILURE;
  const int count = std::atoi(argv[1]), width = std::atoi(argv[2]), height = std::atoi(argv[3]);
  std::vector<std::uint16_t> depth(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int seed = 1; seed <= count; ++seed) {
    SimulatedCamera camera({static_cast<std::uint64_t>(seed), width, height, true});
    camera.capture(0, 0.0, depth.data());
    std::cout << width << ' ' << height << '\n';
    std::cout.write(reinterpret_cast<const char*>(depth.data()),
                    static_cast<std::streamsize>(depth.size() * sizeof(std::uint16_t)));
  }
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
