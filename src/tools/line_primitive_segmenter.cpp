// SPDX-License-Identifier: BSD-3-Clause
#include "line_primitive_segmenter.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <type_traits>

namespace line_plane_segmentation {
namespace {

int scaled(int value, double factor) { return std::max(1, static_cast<int>(std::lround(value * factor))); }

// Resolves the parameters from the image, as PlaneSegmenter does. Only this function depends on that rule.
Parameters resolvedFor(const LabelledFrame& frame, const Parameters& parameters) {
  const int width = parameters.method == Method::kPaper
                        ? frame.depth.cols
                        : kinectWidthOf(frame.camera, frame.depth.cols, frame.depth.rows);
  return resolve(parameters, width);
}

// Scales the spacings that are set; the others follow from the first of them.
void scaleSpacings(double factor, Parameters& parameters) {
  visitParameters(parameters, [factor](const std::string& name, auto& field, auto, auto) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, int>) {
      if (field != 0 && boost::ends_with(name, "_spacing")) field = scaled(field, factor);
    }
  });
}

}  // namespace

void scaleParameter(const ScaledParameter& scaled_parameter, const Parameters& resolved,
                    Parameters& parameters) {
  double value = 0.0;
  visitParameters(resolved, [&](const std::string& name, const auto& field, auto, auto) {
    if (name == scaled_parameter.name) value = static_cast<double>(field);
  });
  const double factor = scaled_parameter.factor;
  visitParameters(parameters, [&](const std::string& name, auto& field, auto, auto) {
    using T = std::decay_t<decltype(field)>;
    if (name != scaled_parameter.name) return;
    if constexpr (std::is_same_v<T, double>) field = value * factor;
    if constexpr (std::is_same_v<T, int>) {
      field = static_cast<int>(std::lround(value * factor));
      if (factor > 1.0) field = std::max(field, static_cast<int>(value) + 1);
      if (factor < 1.0) field = std::min(field, static_cast<int>(value) - 1);
    }
  });
}

std::vector<std::string> scalableParameters(const LabelledFrame& frame, const Parameters& parameters) {
  std::vector<std::string> names;
  const Parameters resolved = resolvedFor(frame, parameters);
  visitParameters(resolved, [&names](const char* name, const auto& value, auto, auto) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>) {
      if (value != T{}) names.emplace_back(name);
    }
  });
  return names;
}

Parameters LinePrimitiveSegmenter::scaledParameters(const LabelledFrame& frame) const {
  Parameters parameters = parameters_;
  if (!scaled_.name.empty()) scaleParameter(scaled_, resolvedFor(frame, parameters_), parameters);
  return parameters;
}

int LinePrimitiveSegmenter::gridSpacing(const LabelledFrame& frame, const FrameVariant& variant) const {
  const Parameters resolved = resolvedFor(frame, scaledParameters(frame));
  return scaled(resolved.scanlines.scanline_spacing, variant.spacing_factor);
}

const Segmentation& LinePrimitiveSegmenter::segmentPlanes(const LabelledFrame& frame,
                                                          const FrameVariant& variant) {
  Parameters parameters = scaledParameters(frame);
  scaleSpacings(variant.spacing_factor, parameters);
  parameters.scanlines.scanline_spacing = gridSpacing(frame, variant);
  parameters.outlines.trace_outlines = false;
  segmenter_.setParameters(parameters);
  const auto depth_unit = static_cast<float>(frame.depth_unit);
  return segmenter_.segment(viewOf(frame.depthPixels(), frame.depth.cols, frame.depth.rows, depth_unit),
                            frame.camera);
}

}  // namespace line_plane_segmentation
