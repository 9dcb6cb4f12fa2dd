// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine.h"

namespace line_plane_segmentation {

/// A method under the name that the reports and the command line know it by.
struct Contestant {
  std::string name;
  bool is_slow = false;  ///< takes so long that a few runs must do
  std::unique_ptr<Engine> engine;
};

/// Whose time all others are compared with.
constexpr const char* kReferenceName = "omps";

/// All methods that run on this processor. This package's own come first.
std::vector<Contestant> allContestants();

/// Those of `names`, in their order; the others are not made.
std::vector<Contestant> contestants(const std::vector<std::string>& names);

}  // namespace line_plane_segmentation
