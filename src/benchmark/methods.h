// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine.h"

namespace line_plane_segmentation {

/// A method, with its name in reports and on the command line.
struct BenchmarkMethod {
  std::string name;
  bool is_slow = false;  ///< takes seconds per frame, so that it is run less often
  std::unique_ptr<Engine> engine;
};

/// The method whose time the others are compared with.
constexpr const char* kReferenceName = "omps";

/// All methods that run on this processor, this package's own first.
std::vector<BenchmarkMethod> allMethods();

/// The methods of these names, in the order of allMethods().
std::vector<BenchmarkMethod> selectMethods(const std::vector<std::string>& names);

}  // namespace line_plane_segmentation
