// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report_frame.h"

namespace line_plane_segmentation {

/// The stages' colours in the report's plots, as CSS has them.
extern const std::array<const char*, kStageCount> kStageColors;

/// Two plots over the frames, as an SVG element for an HTML page: the times of the stages on top of each
/// other, and the numbers of planes. Each column is a link to "#frame-N". Of many frames neighbours share a
/// column that shows their means.
/// @param frames  at least one
std::string summaryPlot(const std::vector<ReportFrame>& frames);

/// A bar as long as the frame took in comparison, cut into its stages.
/// @param full  [ms] of a bar of full length
std::string stageBar(const ReportFrame& frame, double full);

}  // namespace line_plane_segmentation
