// What `mres bench` keeps of its results, and what it finds of them when it resumes.
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

#include "host/bench/results.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;

TEST_F(Bench, ResultsAreOnDiskAfterEachMeasurement) {
  BenchResults results(file(), kMachine, false);
  results.add(measurementOf(0, {64, 64}, 16));
  std::ifstream stream(file());
  EXPECT_EQ(Json::parse(stream), results.report());
}

TEST_F(Bench, ResumingKnowsWhatWasMeasured) {
  {
    BenchResults results(file(), kMachine, false);
    fillReport(results);
  }
  const BenchResults resumed(file(), kMachine, true);
  EXPECT_EQ(resumed.report()["results"].size(), 3U);
  EXPECT_TRUE(resumed.contains(measurementOf(0, {1920, 1080}, 16), {.times = true}));
  EXPECT_FALSE(resumed.contains(measurementOf(1, {1920, 1080}, 16), {.times = true}));
  EXPECT_FALSE(resumed.contains(measurementOf(0, {1920, 1080}, 32), {.times = true}));
  Measurement changed = measurementOf(0, {1920, 1080}, 16);
  changed.settings["radius"] = 2.0;
  EXPECT_FALSE(resumed.contains(changed, {.times = true}));
}

TEST_F(Bench, ResumingTellsScenesOfTheSameNameApart) {
  BenchResults results(file(), kMachine, false);
  const Measurement measured = measurementOf(0, {64, 64}, 16);
  results.add(measured);
  Measurement other = measured;
  other.triangles = 12;
  EXPECT_FALSE(results.contains(other, {}));
  other = measured;
  other.cameraName = "aisle";
  EXPECT_FALSE(results.contains(other, {}));
}

TEST_F(Bench, WithoutResumingAllBeginsAnewAndTheOldIsKept) {
  { BenchResults(file(), kMachine, false).add(measurementOf(0, {64, 64}, 16)); }
  const std::string old = contentsOf(file());
  EXPECT_TRUE(BenchResults(file(), kMachine, false).report()["results"].empty());
  EXPECT_FALSE(fs::exists(file()));
  EXPECT_EQ(contentsOf(folder_ / "results.previous.json"), old);
}

TEST_F(Bench, ResultsAreReadWhateverMeasuredThem) {
  { BenchResults(file(), {"other", "4.6", 64}, false).add(measurementOf(0, {64, 64}, 16)); }
  EXPECT_EQ(readResults(file())["results"].size(), 1U);
  EXPECT_THROW(readResults(folder_ / "missing.json"), std::runtime_error);
  std::ofstream(file()) << "not JSON";
  EXPECT_THROW(readResults(file()), std::runtime_error);
}

TEST(Resuming, ByABuildOfChangedFilesIsNoted) {
  EXPECT_THAT(notesOfResuming("0123456789ab+"),
              testing::ElementsAre(testing::HasSubstr("changed since commit 0123456789ab:")));
  EXPECT_THAT(notesOfResuming("0123456789ab"), testing::IsEmpty());
  EXPECT_THAT(notesOfResuming(""), testing::IsEmpty());
}

TEST_F(Bench, ResumingMeasuresAgainWhatWasNotTimed) {
  Measurement untimed = measurementOf(0, {64, 64}, 16);
  untimed.times.reset();
  { BenchResults(file(), kMachine, false).add(untimed); }
  BenchResults resumed(file(), kMachine, true);
  EXPECT_TRUE(resumed.contains(untimed, {}));
  EXPECT_FALSE(resumed.contains(untimed, {.times = true}));
  resumed.add(measurementOf(0, {64, 64}, 16));
  EXPECT_EQ(resumed.report()["results"].size(), 1U);
  EXPECT_TRUE(resumed.contains(untimed, {.times = true}));
  EXPECT_TRUE(resumed.contains(untimed, {}));
}

TEST_F(Bench, ResumingMeasuresAgainWhatHasNoTruth) {
  BenchResults results(file(), kMachine, false);
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  results.add(measurement);
  EXPECT_TRUE(results.contains(measurement, {.times = true}));
  EXPECT_FALSE(results.contains(measurement, {.times = true, .truth = true}));
  measurement.truths = truthsOf(0.02, 0.03);
  results.add(measurement);
  EXPECT_TRUE(BenchResults(file(), kMachine, true).contains(measurement, {.times = true, .truth = true}));
}

}  // namespace
}  // namespace host::test
