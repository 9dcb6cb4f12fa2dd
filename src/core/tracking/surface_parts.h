// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "line_plane_segmentation/segmentation.h"
#include "tracking/plane_samples.h"
#include "tracking/plane_track.h"

namespace line_plane_segmentation {

/// A surface that objects cut apart, as a desk is, is seen now as one plane, now as several. It is to keep
/// one id nevertheless: that is what these two are for.

/// Notes which tracks are parts of one surface: those that were planes of their own and lie within one plane
/// of this image, as far as they would be seen, and in its direction. Whatever is coplanar but never seen
/// together, as two tables, remains two.
/// @param planes    of this image that are tracked
/// @param track_of  the track of each plane; -1 = it is new
/// @param votes     of the tracks' samples in this image
void joinParts(const std::vector<SegmentedPlane>& planes, const std::vector<int>& track_of,
               const VoteTable& votes, std::vector<PlaneTrack>& tracks);

/// Lets the largest part of a surface that is seen in this image have the surface's id. It goes from one that
/// is seen as well only if that is much smaller; the two then change ids.
/// @param first_seen  the tracks from this index on are the planes of this image
void passIdsOn(std::size_t first_seen, std::vector<PlaneTrack>& tracks);

}  // namespace line_plane_segmentation
