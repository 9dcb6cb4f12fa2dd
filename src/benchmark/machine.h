// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace line_plane_segmentation {

/// The processor and its load, as an item of a Markdown list.
std::string describeProcessor();

/// Where and how the figures came about, as Markdown: the processor and its load, the compiler and its flags,
/// PCL.
std::string describeMachine();

}  // namespace line_plane_segmentation
