// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

/// Counts every allocation of the program that allocation_counter.cpp is linked into, by any library.
namespace line_plane_segmentation {

extern std::atomic<long> allocations;
extern std::atomic<long> live_bytes;  ///< allocated and not freed, with what malloc rounds up
extern std::atomic<long> peak_bytes;  ///< the most that they were

/// Number of allocations while the function runs.
template <typename Function>
long allocationsOf(Function&& function) {
  const long before = allocations;
  function();
  return allocations - before;
}

/// The most memory [bytes] that is in use beyond what is now, while the function runs.
template <typename Function>
long peakOf(Function&& function) {
  const long before = live_bytes;
  peak_bytes = before;
  function();
  return peak_bytes - before;
}

}  // namespace line_plane_segmentation
