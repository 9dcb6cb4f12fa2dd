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

/// A method that finds planes in depth images, as the benchmark runs it.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Takes the frame that segment() works on, and brings it into the form that the method reads. Not timed.
  /// @param frame  lives until the next call
  virtual void load(const BenchmarkFrame& frame) = 0;

  /// Finds the planes of the loaded frame. Timed, and may be called again.
  /// @return how many were found
  virtual int segment() = 0;

  /// The label of every pixel of the loaded frame, row by row: 0 no plane, k the k-th plane. Finds the planes
  /// once more, if it has to. Not timed.
  virtual std::vector<std::uint16_t> labels() = 0;

  /// Of the last call of segment(); null if the method is not made of this package's stages.
  virtual const StageTimes* stageTimes() const { return nullptr; }
};

}  // namespace line_plane_segmentation
