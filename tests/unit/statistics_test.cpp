#include "host/measure/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include "host/measure/interleaved.h"

namespace host {
namespace {

using testing::ElementsAre;

TEST(Median, OfAnOddCountIsTheMiddleValue) {
  EXPECT_EQ(median({9.0, 1.0, 5.0}), 5.0);
}
TEST(Median, OfAnEvenCountIsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({4.0, 1.0, 3.0, 100.0}), 3.5);
}
TEST(Median, OfNothingIsAnError) {
  EXPECT_THROW(median({}), std::invalid_argument);
}

TEST(Mean, IsThatOfTheValues) {
  EXPECT_EQ(mean(std::vector{1.0, 2.0, 6.0}), 3.0);
  EXPECT_THROW(mean({}), std::invalid_argument);
}

TEST(Summary, KeepsTheExtremesAndTheCount) {
  const Summary summary = summarize(std::vector{3.0, 1.0, 2.0, 50.0});
  EXPECT_EQ(summary.median, 2.5);
  EXPECT_EQ(summary.min, 1.0);
  EXPECT_EQ(summary.max, 50.0);
  EXPECT_EQ(summary.runs, 4);
}

TEST(RatioOfMedians, IsExactForTimesThatDoNotVary) {
  const RatioEstimate estimate = ratioOfMedians(std::vector(6, 6.0), std::vector(6, 2.0));
  EXPECT_EQ(estimate.ratio, 3.0);
  EXPECT_EQ(estimate.low, 3.0);
  EXPECT_EQ(estimate.high, 3.0);
  EXPECT_TRUE(estimate.isKnownWithin(0.0));
}

TEST(RatioOfMedians, IsNotMovedByOneDisturbedRun) {
  const std::vector reference{10.0, 10.1, 9.9, 10.0, 10.05, 9.95, 10.0};
  const std::vector technique{5.0, 5.05, 4.95, 5.0, 80.0, 5.0, 5.0};
  EXPECT_NEAR(ratioOfMedians(reference, technique).ratio, 2.0, 0.02);
}

TEST(RatioOfMedians, IntervalContainsTheRatioAndGrowsWithTheSpread) {
  const std::vector steady{10.0, 10.1, 9.9, 10.2, 9.8, 10.0, 10.1};
  const std::vector shaky{10.0, 14.0, 7.0, 12.0, 8.0, 10.0, 13.0};
  const std::vector technique(7, 5.0);
  const RatioEstimate narrow = ratioOfMedians(steady, technique);
  const RatioEstimate wide = ratioOfMedians(shaky, technique);
  EXPECT_LE(narrow.low, narrow.ratio);
  EXPECT_GE(narrow.high, narrow.ratio);
  EXPECT_GT(wide.high - wide.low, narrow.high - narrow.low);
  EXPECT_TRUE(narrow.isKnownWithin(0.05));
  EXPECT_FALSE(wide.isKnownWithin(0.05));
}

TEST(RatioOfMedians, IsNotKnownFromAFewPairsHoweverEqual) {
  EXPECT_FALSE(ratioOfMedians(std::vector(3, 6.0), std::vector(3, 2.0)).isKnownWithin(0.05));
  EXPECT_EQ(ratioOfMedians(std::vector(3, 6.0), std::vector(3, 2.0)).pairs, 3U);
}

TEST(RatioOfMedians, IsTheSameForTheSameTimes) {
  const std::vector reference{10.0, 14.0, 7.0, 12.0, 8.0};
  const std::vector technique{5.0, 6.0, 7.0, 4.0, 5.0};
  EXPECT_EQ(ratioOfMedians(reference, technique).low, ratioOfMedians(reference, technique).low);
}

TEST(EstimateMedian, LiesInItsInterval) {
  const RatioEstimate estimate = estimateMedian(std::vector{10.0, 14.0, 7.0, 12.0, 8.0});
  EXPECT_EQ(estimate.ratio, 10.0);
  EXPECT_GE(estimate.low, 7.0);
  EXPECT_LE(estimate.low, 10.0);
  EXPECT_GE(estimate.high, 10.0);
  EXPECT_LE(estimate.high, 14.0);
}

TEST(RatioOfMedians, RejectsWhatHasNoRatio) {
  EXPECT_THROW(ratioOfMedians({}, {}), std::invalid_argument);
  EXPECT_THROW(ratioOfMedians(std::vector{1.0}, std::vector{1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(ratioOfMedians(std::vector{1.0}, std::vector{0.0}), std::invalid_argument);
}

/// Plays back times instead of measuring, and writes down in which order work was run.
class FakeTimer {
 public:
  RunTime operator()(const Work& work) {
    work();
    return {.wallMs = nextMs, .gpuMs = gpuMs, .trusted = trusted};
  }
  double nextMs = 0.0;
  std::optional<double> gpuMs;
  Clock trusted = Clock::wall;
};

class Interleaved : public testing::Test {
 protected:
  InterleavedTimes run(const RepeatPlan& plan) {
    return timeInterleaved([this] { order_ += 'A', timer_.nextMs = techniqueMs(); },
                           [this] { order_ += 'B', timer_.nextMs = 200.0; }, std::ref(timer_), plan);
  }
  double techniqueMs() { return jitter_ * static_cast<double>(order_.size() % 8) + 100.0; }

  FakeTimer timer_;
  std::string order_;
  double jitter_ = 0.0;
};

TEST_F(Interleaved, WarmsBothUpAndThenTakesTurns) {
  const InterleavedTimes times = run({.pairs = 3});
  EXPECT_EQ(order_,
            "AB"
            "ABABAB");
  EXPECT_EQ(times.technique.size(), 3U);
  EXPECT_EQ(times.reference.size(), 3U);
}

TEST_F(Interleaved, WarmsUpUntilTheClocksHaveSettled) {
  run({.pairs = 1, .warmUpSeconds = 0.35});
  EXPECT_EQ(order_,
            "AAAA"
            "BB"
            "AB");
}

TEST_F(Interleaved, StopsAtTheLeastCountWhenTheRatioIsKnown) {
  EXPECT_EQ(run({}).technique.size(), 6U);
  EXPECT_EQ(speedupOf(run({})).ratio, 2.0);
}

TEST_F(Interleaved, TakesFewerPairsOfWorkThatIsTooLong) {
  // A pair takes 0.3 s.
  EXPECT_EQ(run({.minPairs = 3, .maxSeconds = 0.1, .maxSecondsOfMinPairs = 0.7}).technique.size(), 2U);
  EXPECT_EQ(run({.minPairs = 3, .maxSeconds = 0.1, .maxSecondsOfMinPairs = 0.1}).technique.size(), 1U);
  EXPECT_EQ(run({.minPairs = 3, .maxSeconds = 0.1, .maxSecondsOfMinPairs = 1.0}).technique.size(), 3U);
}

TEST_F(Interleaved, WarmsTheReferenceUpOnlyIfThatIsShort) {
  run({.pairs = 1, .maxSecondsOfWarmUp = 0.05});
  EXPECT_EQ(order_, "AAB");
}

TEST_F(Interleaved, GoesOnWhileTheRatioIsUncertain) {
  jitter_ = 50.0;
  EXPECT_GT(run({.maxPairs = 9, .maxSeconds = 1e9}).technique.size(), 6U);
}

TEST_F(Interleaved, EndsWhenItsTimeIsUp) {
  jitter_ = 500.0;
  EXPECT_LT(run({.maxPairs = 1000, .maxSeconds = 20.0, .precision = 0.0}).technique.size(), 20U);
}

TEST_F(Interleaved, OneWorkAloneIsTimedUntilItsMedianIsKnown) {
  const auto count = [this](const RepeatPlan& plan) {
    order_.clear();
    return timeAlone([this] { order_ += 'A', timer_.nextMs = techniqueMs(); }, std::ref(timer_), plan).size();
  };
  EXPECT_EQ(count({}), 6U);
  EXPECT_EQ(order_, "AAAAAAA") << "one to warm up";
  EXPECT_EQ(count({.pairs = 2}), 2U);
  jitter_ = 50.0;
  EXPECT_GT(count({.maxPairs = 9, .maxSeconds = 1e9}), 5U);
}

TEST_F(Interleaved, TellsHowFarItIs) {
  std::vector<std::pair<int, int>> seen;
  timeAlone([this] { timer_.nextMs = 100.0; }, std::ref(timer_), {.pairs = 2},
            [&](int done, int expected) { seen.emplace_back(done, expected); });
  EXPECT_THAT(seen, ElementsAre(std::pair(0, 2), std::pair(1, 2), std::pair(2, 2)));
}

TEST_F(Interleaved, TrustsTheGpuClockOnlyWhereEveryRunDoes) {
  timer_.gpuMs = 40.0;
  InterleavedTimes times = run({.pairs = 2});
  EXPECT_EQ(trustedClock(times), Clock::wall);
  timer_.trusted = Clock::gpu;
  times = run({.pairs = 2});
  EXPECT_EQ(trustedClock(times), Clock::gpu);
  EXPECT_THAT(timesBy(Clock::gpu, times.technique).value(), ElementsAre(40.0, 40.0));
  times.reference[1].gpuMs.reset();
  EXPECT_EQ(trustedClock(times), Clock::wall);
}

}  // namespace
}  // namespace host
