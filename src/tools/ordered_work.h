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

/// Places for work that goes on at the same time: as many as this machine has cores, and one to get ready
/// meanwhile.
inline std::size_t slotsForAllCores() { return std::max(1U, std::thread::hardware_concurrency()) + 1; }

/// Works on all cores, with the results in order: on the calling thread, `next` fills a slot and `finish`
/// uses up what became of it, both in the order of the input, while `work` runs on the slots in threads.
/// @param slots   memory that is used again and again; as many run at once, so it bounds memory, too
/// @param next    bool(Slot&), false when there is no more
/// @param work    void(Slot&), touches nothing but its slot
/// @param finish  void(Slot&)
/// What any of them throws comes out of here, when all that runs has ended.
template <typename Slot, typename Next, typename Work, typename Finish>
void workInOrder(std::vector<Slot>& slots, Next next, Work work, Finish finish) {
  std::deque<std::future<void>> running;  // the oldest is on slots[first]
  std::size_t first = 0;
  const auto finishOldest = [&] {
    running.front().get();
    running.pop_front();
    finish(slots[first]);
    first = (first + 1) % slots.size();
  };
  for (;;) {
    if (running.size() == slots.size()) finishOldest();
    Slot& slot = slots[(first + running.size()) % slots.size()];
    if (!next(slot)) break;
    running.push_back(std::async(std::launch::async, [&work, &slot] { work(slot); }));
  }
  while (!running.empty()) finishOldest();
}

}  // namespace line_plane_segmentation
