// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "benchmark_frame.h"
#include "line_plane_segmentation/plane_segmenter.h"

namespace line_plane_segmentation {

/// Times of the stages of one frame [ms].
using StageTimes = std::array<double, kStageCount>;

/// A method that segments planes in depth images, as the benchmark runs it.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Sets the frame for segment() and converts it to the method's input format. Not timed.
  /// @param frame  has to outlive its use, until the next call
  virtual void load(const BenchmarkFrame& frame) = 0;

  /// Segments the loaded frame. Timed; may be called repeatedly.
  /// @return number of planes
  virtual int segment() = 0;

  /// The label of every pixel of the loaded frame, row by row: 0 no plane, k the k-th plane. Segments the
  /// frame again if needed. Not timed.
  virtual std::vector<std::uint16_t> labels() = 0;

  /// Times of the last call of segment(); null if the method does not have this package's stages.
  virtual const StageTimes* stageTimes() const { return nullptr; }
};

}  // namespace line_plane_segmentation
