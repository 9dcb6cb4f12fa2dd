// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth/hole_kernels.h"
#include "kernels/row_kernels.h"
#include "lines/line_kernels.h"
#include "lines/window_merging.h"

/// The vectorised functions of row_kernels.h, line_kernels.h, window_merging.h and hole_kernels.h compiled
/// once more for the plainest of machines: loops without vectors, vectors by name in the smallest registers.
namespace scalar_twin {
namespace line_plane_segmentation {

decltype(::line_plane_segmentation::markInliers) markInliers;
decltype(::line_plane_segmentation::countInliers) countInliers;
decltype(::line_plane_segmentation::markRunBoundaries) markRunBoundaries;
decltype(::line_plane_segmentation::linkNeighbors) linkNeighbors;
decltype(::line_plane_segmentation::markChanges) markChanges;
decltype(::line_plane_segmentation::compactIndices) compactIndices;
decltype(::line_plane_segmentation::prepareRow) prepareRow;
decltype(::line_plane_segmentation::assignIfBetter) assignIfBetter;
decltype(::line_plane_segmentation::addRun) addRun;
decltype(::line_plane_segmentation::sumWindows) sumWindows;
decltype(::line_plane_segmentation::mergeWindows) mergeWindows;
decltype(::line_plane_segmentation::markValidityChanges) markValidityChanges;
decltype(::line_plane_segmentation::markHoleEnds) markHoleEnds;
decltype(::line_plane_segmentation::fillSingleHoles) fillSingleHoles;
decltype(::line_plane_segmentation::clearMarked) clearMarked;
decltype(::line_plane_segmentation::clearWithoutDepth) clearWithoutDepth;

}  // namespace line_plane_segmentation
}  // namespace scalar_twin
