// SPDX-License-Identifier: BSD-3-Clause
#include "scalar_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "refine/label_runs.h"

namespace scalar_twin {
namespace line_plane_segmentation {
using namespace ::line_plane_segmentation;  // the types are the same
}  // namespace line_plane_segmentation

// What it includes is known by now, but for the choice of machines, which this turns off.
#define LPS_SCALAR_ONLY
#include "depth/hole_kernels.cpp"
#include "kernels/row_kernels.cpp"
#include "lines/line_kernels.cpp"
#include "lines/window_merging.cpp"

}  // namespace scalar_twin
