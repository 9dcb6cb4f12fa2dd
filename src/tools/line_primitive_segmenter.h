// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "line_plane_segmentation/plane_segmenter.h"
#include "robust_evaluation.h"

namespace line_plane_segmentation {

/// A parameter that is scaled after the image has determined its value.
struct ScaledParameter {
  std::string name;  ///< empty = none
  double factor = 1.0;
};

/// Scales one parameter. An integer changes by at least 1 unless the factor is 1.
/// @param resolved    the parameters with their values for an image
/// @param parameters  receives the scaled value
void scaleParameter(const ScaledParameter& scaled, const Parameters& resolved, Parameters& parameters);

/// The names of the numbers among the parameters that are not 0 for this frame.
std::vector<std::string> scalableParameters(const LabelledFrame& frame, const Parameters& parameters);

/// This package's method. Spacings that the parameters fix are scaled with the variant, too.
class LinePrimitiveSegmenter : public FrameSegmenter {
 public:
  explicit LinePrimitiveSegmenter(const Parameters& parameters, const ScaledParameter& scaled = {})
      : parameters_(parameters), scaled_(scaled) {}
  int gridSpacing(const LabelledFrame& frame, const FrameVariant& variant) const override;
  const std::vector<std::uint16_t>& segment(const LabelledFrame& frame,
                                            const FrameVariant& variant) override {
    return segmentPlanes(frame, variant).labels;
  }

  /// As segment(), with the planes that the labels belong to.
  const Segmentation& segmentPlanes(const LabelledFrame& frame, const FrameVariant& variant);

 private:
  Parameters scaledParameters(const LabelledFrame& frame) const;

  Parameters parameters_;
  ScaledParameter scaled_;
  PlaneSegmenter segmenter_;
};

}  // namespace line_plane_segmentation
