// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// The parameters of the method paper for an image of this width.
inline Parameters paperParameters(int width) {
  Parameters parameters;
  parameters.method = Method::kPaper;
  return resolve(parameters, width);
}

}  // namespace line_plane_segmentation
