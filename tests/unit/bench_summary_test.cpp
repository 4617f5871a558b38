// The rows and sentences that sum up the results of `mres bench`.
#include <cstddef>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/bench/summary.h"
#include "host/bench/truth_summary.h"
#include "host/measure/report.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

using testing::HasSubstr;

TEST(BenchSummary, HasARowForEachEffectSamplesAndSize) {
  Json report = makeReport(kMachine);
  for (const int camera : {0, 1}) report["results"].push_back(toJson(measurementOf(camera, {64, 64}, 16)));
  report["results"].push_back(toJson(measurementOf(0, {32, 32}, 16)));
  report["results"][0]["speedup"] = 3.0;
  const auto rows = summaryRows(report);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[2], testing::ElementsAre("ssao", "16", "64x64", "2", "2.50x", "2.00x", "3.00x", "0.0100",
                                            "0.0100", "0.0100"));
}

/// In pairs that are all alike: its speedup is known exactly if they are enough.
Json timedInPairs(std::size_t pairs, double referenceMs) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.times->technique.assign(pairs, RunTime{.wallMs = 10.0});
  measurement.times->reference.assign(pairs, RunTime{.wallMs = referenceMs});
  return toJson(measurement);
}

TEST(BenchSummary, TellsOfHowManyPicturesTheSpeedupIsKnown) {
  Json report = makeReport(kMachine);
  Json& results = report["results"];
  results = {timedInPairs(6, 20.0), timedInPairs(6, 30.0), timedInPairs(6, 40.0), timedInPairs(1, 90.0)};
  results[1]["speedup_interval"] = {2.8, 3.0};
  results[2]["speedup_interval"] = {4.0, 4.3};
  EXPECT_EQ(speedupCertainty(report),
            "The speedup is known within 5 % (95 % interval) for 1 of 4 timed pictures; "
            "the slowest has one pair.");
  results[1]["speedup_interval"] = {2.9, 3.1};
  results[3]["speedup_interval"] = nullptr;
  results.push_back(timedInPairs(7, 200.0));
  EXPECT_EQ(speedupCertainty(report),
            "The speedup is known within 5 % (95 % interval) for 3 of 5 timed pictures; "
            "the slowest has 7 pairs.");
}

TEST(BenchSummary, TellsNothingOfSpeedupsThatWereNotMeasured) {
  Json report = makeReport(kMachine);
  EXPECT_EQ(speedupCertainty(report), "");
  Measurement untimed = measurementOf(0, {64, 64}, 16);
  untimed.times.reset();
  report["results"].push_back(toJson(untimed));
  EXPECT_EQ(speedupCertainty(report), "");
  report["results"].push_back(timedInPairs(6, 20.0));
  EXPECT_THAT(speedupCertainty(report), HasSubstr("for 1 of 1 timed pictures"));
}

TEST(TruthSummary, HasMeansOfTheViewsThatHaveTruths) {
  const auto rows = truthSummaryRows(reportWithTruths());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_THAT(rows[1], testing::ElementsAre("ssao", "16", "64x64", "converged, 4096 samples", "2", "0.0200",
                                            "0.0300", "+50.0 %"));
  Json without = makeReport(kMachine);
  without["results"].push_back(toJson(measurementOf(0, {64, 64}, 16)));
  EXPECT_TRUE(truthSummaryRows(without).empty());
}

}  // namespace
}  // namespace host::test
