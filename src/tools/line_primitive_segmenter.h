// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "robust_evaluation.h"

namespace line_plane_segmentation {

/// Parameter that is scaled after it was resolved from the image width.
struct ScaledParameter {
  std::string name;  ///< empty = none
  double factor = 1.0;
};

/// Scales one parameter. An integer changes by at least 1 unless the factor is 1.
/// @param resolved    the parameters with their values for an image
/// @param parameters  receives the scaled value
void scaleParameter(const ScaledParameter& scaled, const Parameters& resolved, Parameters& parameters);

/// Returns the names of the numeric parameters that are not 0 for this frame.
std::vector<std::string> scalableParameters(const LabelledFrame& frame, const Parameters& parameters);

/// Adapter of PlaneSegmenter for the evaluation. A spacing that is set by the parameters is scaled with the
/// variant.
class LinePrimitiveSegmenter : public FrameSegmenter {
 public:
  explicit LinePrimitiveSegmenter(const Parameters& parameters, const ScaledParameter& scaled = {})
      : parameters_(parameters), scaled_(scaled) {}
  int gridSpacing(const LabelledFrame& frame, const FrameVariant& variant) const override;
  const std::vector<std::uint16_t>& segment(const LabelledFrame& frame,
                                            const FrameVariant& variant) override {
    return segmentPlanes(frame, variant).labels;
  }

  /// Same as segment(), but returns the planes as well.
  const Segmentation& segmentPlanes(const LabelledFrame& frame, const FrameVariant& variant);

 private:
  Parameters scaledParameters(const LabelledFrame& frame) const;

  Parameters parameters_;
  ScaledParameter scaled_;
  PlaneSegmenter segmenter_;
};

}  // namespace line_plane_segmentation
