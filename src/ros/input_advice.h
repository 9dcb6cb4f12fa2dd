// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <set>
#include <string>

#include "camera_frame.h"
#include "line_plane_segmentation/ros/image_validation.h"
#include "line_plane_segmentation/segmentation.h"
#include "transform_lookup.h"

namespace line_plane_segmentation {

/// Purpose of a transform.
enum class Purpose { kTarget, kGravity, kMotion };

constexpr std::size_t kPurposeCount = 3;

/// Logs warnings about unusual input without flooding the log: each kind once, refusals at most every few
/// seconds. Uses the steady clock, independent of simulated time. Each instance throttles on its own, so
/// nodelets in one process do not affect each other.
class InputAdvice {
 public:
  /// @param name  name of the nodelet, at the beginning of each line
  explicit InputAdvice(std::string name) : name_(std::move(name)) {}

  /// Registers a tf lookup. Single failures are normal; warns if most lookups fail.
  /// @param patience  [s] that was waited for it
  void transformed(Purpose purpose, const TransformLookup& lookup, double patience);

  /// Registers a refused frame.
  void refused(Refusal refusal, const std::string& explanation);

  /// Registers a frame whose processing threw an exception.
  void failed(const std::string& problem);

  /// Registers an accepted frame, and warns if it is unusual.
  void accepted(const CameraFrame& frame, const Validation& input);

  /// Registers its segmentation, and warns if most depths are out of range.
  void segmented(const Validation& input, const DepthRange& range, const Segmentation& segmentation);

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  struct Transforms {
    int found = 0;  // lookups since the last warning
    int failed = 0;
    TimePoint last_warning{};
  };

  bool isDue(TimePoint& last);
  void once(bool& told, const std::string& text);
  void adviseOnRange(const DepthView& depth, const DepthRange& range);

  std::string name_;
  std::array<TimePoint, kRefusalCount> last_refused_{};
  std::array<Transforms, kPurposeCount> transforms_;
  TimePoint last_failed_{};
  bool told_intrinsics_from_k_ = false;
  bool told_distorted_ = false;
  bool told_slash_ = false;
  bool told_no_frame_ = false;
  bool told_other_frame_ = false;
  bool told_out_of_range_ = false;
  bool told_no_plane_ = false;
  int without_plane_ = 0;  // images in a row with depth, but without a plane
};

/// Fractions of the pixels with any depth that are out of range, from a sample of the rows; 0 to 1.
struct OutOfRange {
  double near = 0.0;    ///< not farther than the least depth
  double beyond = 0.0;  ///< not nearer than the largest
};

OutOfRange fractionsOutOfRange(const DepthView& depth, const DepthRange& range);

}  // namespace line_plane_segmentation
