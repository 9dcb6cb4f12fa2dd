// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "frame_segmenter.h"
#include "published_planes.h"

namespace line_plane_segmentation {

/// Expects that a refusal is explained in one line, and that nothing of a refused frame can be looked at.
void expectExplained(const Validation& input, const std::string& explanation);

/// Makes all messages of the segmenter's last frame, and expects of them what is promised, whatever the frame
/// was: finite numbers, labels and counts that agree.
void expectSoundMessages(FrameSegmenter& segmenter, const PublishedPlanes& published);

}  // namespace line_plane_segmentation
