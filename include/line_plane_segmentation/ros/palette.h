// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Former path of the palette, kept for programs that include it.
#include "line_plane_segmentation/palette.h"
