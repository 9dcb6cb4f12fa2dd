// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// Processor time that this process has used [ms]. In a process of one thread it is the time that has passed,
/// less what other programs took of the processor: a long run would suffer from them where a short one slips
/// through, and ratios would tell about the machine's load.
double processorMilliseconds();

}  // namespace line_plane_segmentation
