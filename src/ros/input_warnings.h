// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <set>
#include <string>

#include "image_validation.h"
#include "input_frame.h"
#include "line_plane_segmentation/segmentation.h"
#include "transform_lookup.h"

namespace line_plane_segmentation {

/// TransformPurpose of a transform.
enum class TransformPurpose { kTarget, kGravity, kFixed };

constexpr std::size_t kTransformPurposeCount = 3;

/// Logs warnings about unusual input without flooding the log: each kind once, refusals at most every five
/// seconds. Uses the steady clock, independent of simulated time. Each instance throttles on its own, so
/// nodelets in one process do not affect each other.
class InputWarnings {
 public:
  /// @param name  name of the nodelet, at the beginning of each line
  explicit InputWarnings(std::string name) : name_(std::move(name)) {}

  /// Counts a tf lookup, and warns if most lookups for this purpose fail. Single failures are normal.
  /// @param patience  [s] time that the lookup was waited for
  void countLookup(TransformPurpose purpose, const TransformLookup& lookup, double patience);

  /// Warns about a refused frame.
  void warnAboutRefusal(Refusal refusal, const std::string& explanation);

  /// Logs an error for a frame whose processing threw an exception.
  void warnAboutFailure(const std::string& problem);

  /// Warns if an accepted frame is unusual: distortion, missing P, frame_id.
  void checkFrame(const InputFrame& frame, const Validation& input);

  /// Warns if most depths of a frame are out of range, or if many frames have no plane.
  void checkSegmentation(const Validation& input, const DepthRange& range, const Segmentation& segmentation);

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  struct Transforms {
    int found = 0;  // lookups since the last warning
    int failed = 0;
    TimePoint last_warning{};
  };

  bool isDue(TimePoint& last);
  void warnOnce(bool& warned, const std::string& text);
  void warnAboutRange(const DepthView& depth, const DepthRange& range);

  std::string name_;
  std::array<TimePoint, kRefusalCount> last_refused_{};
  std::array<Transforms, kTransformPurposeCount> transforms_;
  TimePoint last_failed_{};
  bool warned_intrinsics_from_k_ = false;
  bool warned_distorted_ = false;
  bool warned_slash_ = false;
  bool warned_no_frame_ = false;
  bool warned_other_frame_ = false;
  bool warned_out_of_range_ = false;
  bool warned_no_plane_ = false;
  int without_plane_ = 0;  // consecutive images with depth, but without a plane
};

/// Fractions, 0 to 1, of the pixels with a depth that are out of range.
struct OutOfRange {
  double near = 0.0;    ///< at most the minimum of the range
  double beyond = 0.0;  ///< at least the maximum of the range
};

/// Computes both fractions from every 16th row.
OutOfRange fractionsOutOfRange(const DepthView& depth, const DepthRange& range);

}  // namespace line_plane_segmentation
