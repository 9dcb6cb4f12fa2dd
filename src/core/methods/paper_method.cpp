// SPDX-License-Identifier: BSD-3-Clause
#include "methods/paper_method.h"

#include "planes/candidate_detection.h"

namespace line_plane_segmentation {

void PaperMethod::extractLines(Frame& frame) {
  line_extractor_.extract(frame.depth, frame.camera, frame.parameters, segments_);
}

void PaperMethod::detectCandidates(const Frame& frame) {
  line_plane_segmentation::detectCandidates(frame.depth, frame.rays, segments_, frame.parameters.candidates,
                                            candidates_);
}

void PaperMethod::extractPlanes(const Frame& frame, StageObserver& observer, LabeledPlanes& planes) {
  labels_.assign(frame.depth.z.size(), 0);
  planes.label_count =
      plane_extractor_.extract(frame.depth, frame.rays, candidates_, frame.parameters, labels_, &observer);
  planes.runs.scan(labels_, frame.depth.width, frame.depth.height);
  planes.estimates.clear();
}

void PaperMethod::describe(const Frame&, std::vector<LineSegment>& segments,
                           std::vector<PlaneCandidate>& candidates) const {
  segments = segments_;
  candidates = candidates_;
}

}  // namespace line_plane_segmentation
