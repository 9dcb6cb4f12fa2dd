// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "engine.h"

namespace line_plane_segmentation {

/// The paper's baselines, all from the Point Cloud Library.
enum class PclMethod {
  kOmps,         ///< organised multi-plane segmentation
  kOmpsRefined,  ///< the same with its refinement
  kRansac,       ///< the largest plane by RANSAC, again and again
  kRegionGrowing,
};

/// A baseline from PCL's shared libraries, as the distribution compiled them.
std::unique_ptr<Engine> makePclEngine(PclMethod method);

/// A baseline whose templates were compiled here with AVX2 and FMA. Only for processors that have them.
/// @return null for region growing
/// Defined where PCL_ENGINES_WITH_AVX2 is.
std::unique_ptr<Engine> makePclEngineWithAvx2(PclMethod method);

}  // namespace line_plane_segmentation
