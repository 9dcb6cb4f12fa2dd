// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line_plane_segmentation/parameters.h"

namespace line_plane_segmentation {

/// The parameters of a method for an image of this width.
inline Parameters resolvedParameters(Method method, int width) {
  Parameters parameters;
  parameters.method = method;
  return resolve(parameters, width);
}

inline Parameters paperParameters(int width) { return resolvedParameters(Method::kPaper, width); }
inline Parameters adaptiveParameters(int width) { return resolvedParameters(Method::kAdaptive, width); }

}  // namespace line_plane_segmentation
