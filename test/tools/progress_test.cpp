// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <stdexcept>

#include "interruption.h"
#include "ordered_work.h"
#include "run_tool.h"

namespace line_plane_segmentation {
namespace {

TEST(Progress, TellsFramesRateAndTimeLeft) {
  EXPECT_EQ(progressText(150, 0.25, 10.0),
            "[=======>                    ]  25 %  150 frames  15/s  0:30 left");
  EXPECT_EQ(progressText(3, 0.5, 2.0), "[==============>             ]  50 %  3 frames  1.5/s  0:02 left");
  EXPECT_EQ(progressText(100, 0.001, 10.0),
            "[>                           ]   0 %  100 frames  10/s  2:46:30 left");
  EXPECT_EQ(progressText(9000, 1.0, 60.0), "[============================] 100 %  9000 frames  150/s");
  EXPECT_EQ(progressText(0, 0.0, 0.0), "[>                           ]   0 %  0 frames  0.0/s");
}

struct Slot {
  int number = 0;
  int square = 0;
};

TEST(WorkInOrder, GivesResultsInTheOrderOfTheInput) {
  std::vector<Slot> slots(3);
  int given = 0;
  std::vector<int> results;
  workInOrder(
      slots,
      [&](Slot& slot) {
        slot.number = given;
        return given++ < 50;
      },
      [](Slot& slot) {
        // The first of each three takes longest.
        std::this_thread::sleep_for(std::chrono::milliseconds(slot.number % 3 == 0 ? 5 : 0));
        slot.square = slot.number * slot.number;
      },
      [&](Slot& slot) { results.push_back(slot.square); });
  ASSERT_EQ(results.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(results[static_cast<std::size_t>(i)], i * i);
}

TEST(WorkInOrder, WorksOnSeveralAtOnce) {
  std::vector<Slot> slots(2);
  int given = 0;
  std::atomic<int> arrived{0};
  workInOrder(
      slots, [&](Slot&) { return given++ < 2; },
      [&](Slot&) {
        // Neither ends before the other has begun.
        ++arrived;
        for (int i = 0; i < 5000 && arrived < 2; ++i)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
      },
      [&](Slot&) { EXPECT_EQ(arrived, 2); });
}

TEST(WorkInOrder, HandsOnWhatIsThrownAfterWhatCameBefore) {
  std::vector<Slot> slots(4);
  int given = 0;
  int finished = 0;
  EXPECT_THROW(workInOrder(
                   slots,
                   [&](Slot& slot) {
                     slot.number = given++;
                     return true;
                   },
                   [](Slot& slot) {
                     if (slot.number == 7) throw std::runtime_error("seven");
                   },
                   [&](Slot&) { ++finished; }),
               std::runtime_error);
  EXPECT_EQ(finished, 7);
}

TEST(Interruption, IsNoticedWhereItIsAskedFor) {
  catchInterruption();
  EXPECT_NO_THROW(stopIfInterrupted());
  std::raise(SIGINT);
  EXPECT_THROW(stopIfInterrupted(), BadInput);
}

}  // namespace
}  // namespace line_plane_segmentation
