// The plots of `mres bench`.
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "host/bench/plots.h"
#include "host/bench/results.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> namesOf(const std::vector<Plot>& plots) {
  std::vector<std::string> names;
  names.reserve(plots.size());
  for (const Plot& plot : plots) names.push_back(plot.file.string());
  return names;
}

TEST_F(Bench, PlotsAreDrawnFromTheReportAlone) {
  BenchResults results(file(), kMachine, false);
  fillReport(results);
  const auto plots = drawPlots(results.report(), folder_);
  if (!plots) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_THAT(namesOf(*plots), ElementsAre("plots/speedup-by-size.svg", "plots/speedup-by-samples.svg",
                                           "plots/error-against-time.svg", "plots/stages.svg"));
  for (const Plot& plot : *plots)
    EXPECT_THAT(contentsOf(folder_ / plot.file),
                AllOf(HasSubstr("<svg"), HasSubstr(plot.title.substr(0, 5)), HasSubstr("</svg>")))
        << plot.file;
}

TEST_F(Bench, PlotsOfBeforeAreTakenAway) {
  fs::create_directory(folder_ / "plots");
  for (const char* name : {"old.svg", "old.gp", "notes.txt"}) std::ofstream(folder_ / "plots" / name) << "";
  BenchResults results(file(), kMachine, false);
  results.add(measurementOf(0, {64, 64}, 16));
  drawPlots(results.report(), folder_);
  EXPECT_FALSE(fs::exists(folder_ / "plots/old.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "plots/old.gp"));
  EXPECT_TRUE(fs::exists(folder_ / "plots/notes.txt"));
}

TEST_F(Bench, BarsOfStagesAreInTheOrderOfNumbers) {
  BenchResults results(file(), kMachine, false);
  for (const int samples : {128, 16}) {
    Measurement measurement = measurementOf(0, {64, 64}, samples);
    measurement.scene = R"(the "hall")";
    results.add(measurement);
  }
  if (!drawPlots(results.report(), folder_)) GTEST_SKIP() << "gnuplot is not installed";
  const std::string script = contentsOf(folder_ / "plots/stages.gp");
  const std::size_t first = script.find("\n\"the hall 0, ssao, 16 samples");
  EXPECT_NE(first, std::string::npos) << script;
  EXPECT_NE(script.find("\n\"the hall 0, ssao, 128 samples", first), std::string::npos) << script;
}

TEST_F(Bench, ManyViewsAreDrawnAsMeansAndBoxes) {
  BenchResults results(file(), kMachine, false);
  for (int camera = 0; camera < 13; ++camera) {
    for (const int samples : {16, 32, 64}) results.add(measurementOf(camera, {1920, 1080}, samples));
    results.add(measurementOf(camera, {3840, 2160}, 64));
  }
  const auto plots = drawPlots(results.report(), folder_);
  if (!plots) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_THAT(namesOf(*plots),
              ElementsAre("plots/mean-speedup-by-size.svg", "plots/mean-speedup-by-samples.svg",
                          "plots/errors.svg", "plots/error-against-time.svg", "plots/stages.svg"));
  EXPECT_THAT(contentsOf(folder_ / "plots/mean-speedup-by-size.svg"),
              HasSubstr("ssao, 64 samples, 13 views"));
  EXPECT_THAT(contentsOf(folder_ / "plots/mean-speedup-by-samples.svg"),
              HasSubstr("ssao, 1920x1080, 13 views"));
  // The largest pictures that most views have.
  EXPECT_THAT(contentsOf(folder_ / "plots/errors.svg"), HasSubstr("3840x2160"));
}

TEST_F(Bench, AViewWithMorePointsThanTheOthersIsDrawnAlone) {
  BenchResults results(file(), kMachine, false);
  for (const int camera : {0, 1})
    for (const int samples : {16, 32, 64}) results.add(measurementOf(camera, {64, 64}, samples));
  results.add(measurementOf(1, {64, 64}, 128));
  if (!drawPlots(results.report(), folder_)) GTEST_SKIP() << "gnuplot is not installed";
  const std::string script = contentsOf(folder_ / "plots/mean-speedup-by-samples.gp");
  EXPECT_THAT(script, AllOf(HasSubstr("'ssao, 64x64, 2 views'"), HasSubstr("'ssao, 64x64, hall <1> 1 alone'"),
                            testing::Not(HasSubstr("hall <1> 0 alone"))));
  EXPECT_EQ(countOf(script, "\n128 "), 1U);
}

}  // namespace
}  // namespace host::test
