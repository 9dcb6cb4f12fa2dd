// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "line_plane_segmentation/segmentation.h"

namespace line_plane_segmentation {

/// Kinds of label images, each hard to outline in its own way.
enum class OutlinePicture {
  kNoise,         ///< every pixel for itself, sparse to dense
  kBlobs,         ///< discs put in and taken out, with ragged borders
  kSpiral,        ///< one or two pixels wide, gaps as narrow
  kCheckerboard,  ///< everything touches at corners
  kLines,         ///< one pixel wide, also as gaps, also diagonal
  kNestedRings,   ///< holes in islands in holes
  kStripes,       ///< slanted, parallel, a pixel or two apart
  kMosaic,        ///< several planes that share ragged borders
  kComb,          ///< long thin teeth
  kFull,          ///< one plane everywhere, with a few holes
};

constexpr OutlinePicture kAllOutlinePictures[] = {OutlinePicture::kNoise,   OutlinePicture::kBlobs,
                                                  OutlinePicture::kSpiral,  OutlinePicture::kCheckerboard,
                                                  OutlinePicture::kLines,   OutlinePicture::kNestedRings,
                                                  OutlinePicture::kStripes, OutlinePicture::kMosaic,
                                                  OutlinePicture::kComb,    OutlinePicture::kFull};

std::string nameOf(OutlinePicture picture);

/// A picture of one kind, as the seed has it, with planes that are tilted at random.
Segmentation outlinePicture(OutlinePicture picture, int width, int height, std::uint64_t seed);

}  // namespace line_plane_segmentation
