// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "processor_clock.h"

namespace line_plane_segmentation {
namespace {

/// Records the calls that it gets. The runs of a frame alternate between 2 ms and none of processor time.
class Recorder : public Engine {
 public:
  Recorder(char name, std::string& log) : name_(name), log_(log) {}
  void load(const BenchmarkFrame& frame) override { frame_ = frame.name; }
  int segment() override {
    log_ += name_ + frame_ + ' ';
    busy_ = !busy_;
    const double end = processorMilliseconds() + (busy_ ? 2.0 : 0.0);
    while (processorMilliseconds() < end) {
    }
    return 7;
  }
  std::vector<std::uint16_t> labels() override { return {}; }

 private:
  char name_;
  bool busy_ = true;
  std::string frame_;
  std::string& log_;
};

BenchmarkFrame named(const std::string& name) {
  BenchmarkFrame frame;
  frame.name = name;
  return frame;
}

class Measure : public testing::Test {
 protected:
  Measure() {
    methods_.push_back({"fast", false, std::make_unique<Recorder>('f', log_)});
    methods_.push_back({"slow", true, std::make_unique<Recorder>('s', log_)});
  }
  std::string log_;
  std::vector<BenchmarkMethod> methods_;
};

TEST_F(Measure, TakesMethodsInTurnAndSparesTheSlowOnes) {
  const auto results = measure({named("1"), named("2")}, methods_, {2, 1, false});
  EXPECT_EQ(log_, "f1 f2 f1 f1 s1 f2 f2 s2 f1 f1 f2 f2 ");
  ASSERT_EQ(results.size(), 4U);
  EXPECT_EQ(results[0].frame + results[0].method, "1fast");
  EXPECT_EQ(results[3].frame + results[3].method, "2slow");
  EXPECT_EQ(results[0].total.runs, 2) << "the first round is not timed";
  EXPECT_EQ(results[1].total.runs, 1);
  EXPECT_EQ(results[2].planes, 7);
  EXPECT_TRUE(results[0].stages.empty());
}

TEST_F(Measure, TimesColdAndWarmRunsByBothClocks) {
  // Every frame's rounds: a first one that is not timed, then a cold and a warm run each.
  const auto results = measure({named("1")}, methods_, {3, 1, false});
  const Measurement& fast = results[0];
  ASSERT_TRUE(fast.cold && fast.warm);
  EXPECT_EQ(fast.cold->processor.runs, 3);
  EXPECT_EQ(fast.warm->wall.runs, 3);
  EXPECT_GE(fast.cold->processor.median, 2.0);
  EXPECT_LT(fast.warm->processor.median, 2.0);
  EXPECT_GE(fast.cold->wall.median, 1.5);
  EXPECT_EQ(fast.total.median, fast.cold->processor.median);
  EXPECT_TRUE(results[1].cold.has_value());
  EXPECT_FALSE(results[1].warm.has_value()) << "slow methods run once";

  const auto warm = measure({named("1")}, methods_, {3, 1, true});
  EXPECT_EQ(warm[0].total.median, warm[0].warm->processor.median);
  EXPECT_EQ(warm[1].total.median, warm[1].cold->processor.median);
}

TEST(StatisticsOf, OddEvenAndOne) {
  const Statistics odd = statisticsOf({5.0, 1.0, 2.0});
  EXPECT_DOUBLE_EQ(odd.median, 2.0);
  EXPECT_DOUBLE_EQ(odd.min, 1.0);
  EXPECT_DOUBLE_EQ(odd.max, 5.0);
  EXPECT_EQ(odd.runs, 3);
  EXPECT_DOUBLE_EQ(statisticsOf({8.0, 1.0, 2.0, 4.0}).median, 3.0);
  EXPECT_DOUBLE_EQ(statisticsOf({4.0}).median, 4.0);
}

TEST(StatisticsOf, Percentiles) {
  std::vector<double> times;
  for (int i = 200; i >= 1; --i) times.push_back(i);
  EXPECT_DOUBLE_EQ(statisticsOf(times).p90, 180.0);
  EXPECT_DOUBLE_EQ(statisticsOf(times).p99, 198.0);
  EXPECT_DOUBLE_EQ(statisticsOf({4.0}).p99, 4.0);
  EXPECT_DOUBLE_EQ(statisticsOf({1.0, 2.0}).p90, 2.0);
}

}  // namespace
}  // namespace line_plane_segmentation
