// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace line_plane_segmentation {

/// Number of slots for workInOrder(): one per core, and one that is filled in the meantime.
inline std::size_t slotsForAllCores() { return std::max(1U, std::thread::hardware_concurrency()) + 1; }

/// Processes items in parallel and returns the results in order. The calling thread runs `next`, which fills
/// a slot, and `finish`, which uses its result, both in the order of the input. `work` runs on the slots in
/// threads.
/// @param slots   reused memory; their number limits the items in progress, and so the memory
/// @param next    bool(Slot&), false after the last item
/// @param work    void(Slot&), accesses only its slot
/// @param finish  void(Slot&)
/// Rethrows an exception of any of them when all running work has ended.
template <typename Slot, typename Next, typename Work, typename Finish>
void workInOrder(std::vector<Slot>& slots, Next next, Work work, Finish finish) {
  std::deque<std::future<void>> running;  // the oldest is on slots[first]
  std::size_t first = 0;
  const auto finish_oldest = [&] {
    running.front().get();
    running.pop_front();
    finish(slots[first]);
    first = (first + 1) % slots.size();
  };
  for (;;) {
    if (running.size() == slots.size()) finish_oldest();
    Slot& slot = slots[(first + running.size()) % slots.size()];
    if (!next(slot)) break;
    running.push_back(std::async(std::launch::async, [&work, &slot] { work(slot); }));
  }
  while (!running.empty()) finish_oldest();
}

}  // namespace line_plane_segmentation
