// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"

#include <Eigen/Core>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <thread>

namespace line_plane_segmentation {
namespace {

std::string processorName() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

std::string loadAverage() {
  double load = 0.0;
  if (getloadavg(&load, 1) != 1) return "unknown";
  std::ostringstream text;
  text << std::setprecision(2) << std::fixed << load;
  return text.str();
}

}  // namespace

std::string describeProcessor() {
  return "- " + processorName() + ", " + std::to_string(std::thread::hardware_concurrency()) +
         " processors; load average at the end " + loadAverage() + '\n';
}

std::string describeMachine() {
  std::ostringstream text;
  text << describeProcessor() << "- GCC or Clang `" << __VERSION__ << "`, " << BENCHMARK_BUILD_TYPE << ": `"
       << BENCHMARK_FLAGS << "` for every method; this method `" << BENCHMARK_CORE_FLAGS << "` besides\n"
       << "- PCL " << BENCHMARK_PCL_VERSION
       << " as the distribution compiled it; `_avx2`: its templates compiled here with `-mavx2 -mfma`\n"
       << "- Eigen " << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION
       << '\n'
       << "- Times are processor time of the process, which has one thread, unless called wall time. In each "
          "round every "
          "method gets a frame before the next frame comes. Making PCL's clouds is not timed; this method "
          "starts from "
          "the 16-bit depth image.\n";
  return text.str();
}

}  // namespace line_plane_segmentation
