// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "measurement.h"

namespace line_plane_segmentation {

/// Draws the times of the methods on the frames of the first measurement's size, one panel for each frame:
/// from the smallest to the largest time on a logarithmic axis, the median as a dot.
/// @param measurements  at least one
/// @return 8-bit BGR
cv::Mat drawTimes(const std::vector<Measurement>& measurements);

}  // namespace line_plane_segmentation
