// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// Processor time that this process has used [ms]. Unlike wall time it excludes the time in which other
/// programs use the processor. These interrupt long runs more often than short ones, so ratios of wall times
/// depend on the load.
double processorMilliseconds();

}  // namespace line_plane_segmentation
