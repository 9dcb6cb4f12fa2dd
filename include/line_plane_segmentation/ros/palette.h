// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The palette's earlier place, for programs that include it from there.
#include "line_plane_segmentation/palette.h"
