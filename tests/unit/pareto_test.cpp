// Time against error: who is dominated, and how curves are read.
#include "host/bench/pareto.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "host/bench/pareto_plots.h"
#include "host/bench/pareto_tables.h"
#include "host/bench/plots.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

ParetoPoint point(const std::string& name, double time, double rms) {
  return {.technique = name, .name = name, .time = time, .rms = rms};
}

TEST(Domination, IsByLessTimeAndNoMoreError) {
  std::vector<ParetoPoint> points{point("exact", 1.0, 0.0),    point("good", 0.5, 0.01),
                                  point("as good", 0.6, 0.01), point("worse", 0.7, 0.02),
                                  point("fast", 0.1, 0.05),    point("twin", 0.1, 0.05)};
  findDominators(points);
  std::vector<std::string> dominators;
  dominators.reserve(points.size());
  for (const ParetoPoint& each : points) dominators.push_back(each.dominator);
  EXPECT_THAT(dominators, ElementsAre("", "", "good", "good", "", ""));
}

TEST(Domination, NamesTheFastest) {
  std::vector<ParetoPoint> points{point("slow", 0.9, 0.02), point("fast", 0.1, 0.02),
                                  point("last", 1.0, 0.03)};
  findDominators(points);
  EXPECT_EQ(points[2].dominator, "fast");
}

const std::vector<ErrorAndTime> kCurve{{0.04, 0.1}, {0.01, 0.4}, {0.0025, 0.8}};

TEST(TimeAlong, ACurveIsStraightInLogarithms) {
  EXPECT_DOUBLE_EQ(timeAlong(kCurve, 0.01).value(), 0.4);
  EXPECT_DOUBLE_EQ(timeAlong(kCurve, 0.04).value(), 0.1);
  EXPECT_NEAR(timeAlong(kCurve, 0.02).value(), 0.2, 1e-12) << "half of the way, by factors of two";
  EXPECT_NEAR(timeAlong(kCurve, 0.005).value(), std::sqrt(0.4 * 0.8), 1e-12);
}

TEST(TimeAlong, NothingOutsideOfTheCurve) {
  EXPECT_FALSE(timeAlong(kCurve, 0.0024));
  EXPECT_FALSE(timeAlong(kCurve, 0.041));
  EXPECT_FALSE(timeAlong({}, 0.01));
  EXPECT_FALSE(timeAlong({{0.01, 0.4}}, 0.01)) << "a point is no curve";
}

TEST(TimeAlong, ThereIsNoWayToNoErrorButByThePointThatHasNone) {
  EXPECT_DOUBLE_EQ(timeAlong({{0.0, 1.0}, {0.01, 0.4}}, 0.005).value(), 1.0);
}

TEST(TimeWithin, IsThatOfAPointThatErrsLess) {
  EXPECT_DOUBLE_EQ(timeWithin({{0.004, 0.3}}, 0.005).value(), 0.3);
  EXPECT_FALSE(timeWithin({{0.006, 0.3}}, 0.005));
  EXPECT_DOUBLE_EQ(timeWithin(kCurve, 0.1).value(), 0.1) << "beyond the curve the cheapest";
  EXPECT_NEAR(timeWithin(kCurve, 0.02).value(), 0.2, 1e-12) << "on it what is between its points";
}

struct Made {
  const char* technique;
  double errorBudget;
  int samples;
  double time;
  double rms;
};

Json resultOf(const Made& made, int camera) {
  Measurement measurement = measurementOf(camera, {1920, 1080}, made.samples);
  measurement.technique = made.technique;
  measurement.referenceSamples = 64;
  measurement.settings = {{"samples", made.samples}, {"errorBudget", made.errorBudget}};
  measurement.error->rms = made.rms;
  measurement.error->blocks.percentile99 = 2.0 * made.rms;
  Json result = toJson(measurement);
  result["speedup"] = 1.0 / made.time;
  return result;
}

/// Of two views that differ by nothing but the error.
Json reportOfRivals() {
  Json report = makeReport(kMachine);
  for (const Made& made : {Made{"mres", 0.01, 64, 0.4, 0.01}, Made{"mres", 0.04, 64, 0.1, 0.04},
                           Made{"half-joint", 0.01, 64, 0.5, 0.02}, Made{"full", 0.01, 16, 0.25, 0.08}})
    for (const int camera : {0, 1}) {
      Made view = made;
      view.rms *= camera == 0 ? 0.5 : 1.5;
      report["results"].push_back(resultOf(view, camera));
    }
  return report;
}

TEST(Planes, HaveMeansOfTheViewsAndTheReferenceItself) {
  const std::vector<ParetoPlane> planes = paretoPlanes(reportOfRivals());
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(titleOf(planes[0]), "ssao 64, 1920x1080, 2 views");
  std::vector<std::string> names;
  names.reserve(planes[0].points.size());
  for (const ParetoPoint& each : planes[0].points) names.push_back(each.name);
  EXPECT_THAT(names, ElementsAre("full", "mres, budget 0.04", "full, 16 samples", "mres", "half-joint"));
  EXPECT_NEAR(planes[0].points[3].rms, 0.01, 1e-12);
  EXPECT_NEAR(planes[0].points[3].time, 0.4, 1e-12);
  EXPECT_NEAR(planes[0].points[3].blockPercentile99, 0.02, 1e-12);
  EXPECT_EQ(planes[0].points[2].dominator, "mres, budget 0.04");
  EXPECT_EQ(planes[0].points[4].dominator, "mres");
}

TEST(Planes, LeaveOutWhatLacksAView) {
  Json report = reportOfRivals();
  report["results"].erase(report["results"].size() - 1);
  EXPECT_EQ(paretoPlanes(report)[0].points.size(), 4U);
}

TEST(Planes, AreNoneOfOneTechnique) {
  Json report = makeReport(kMachine);
  report["results"].push_back(toJson(measurementOf(0, {64, 64}, 16)));
  EXPECT_TRUE(paretoPlanes(report).empty());
  EXPECT_EQ(paretoMarkdown(report), "");
  EXPECT_EQ(withoutRivals(report), report);
}

TEST(Planes, KnowTruthAndFlickerWhereTheyWereMeasured) {
  Json report = reportOfRivals();
  report["results"][0]["truth"] = {{"converged", {{"rms", 0.03}, {"reference_rms", 0.02}}}};
  report["results"][0]["temporal"] = {{"frames", 4}, {"rms", 0.005}};
  const ParetoPlane plane = paretoPlanes(report)[0];
  EXPECT_EQ(plane.points[0].convergedRms, 0.02);
  EXPECT_EQ(plane.points[3].convergedRms, 0.03);
  EXPECT_EQ(plane.points[3].flickerRms, 0.005);
  EXPECT_FALSE(plane.points[4].convergedRms);
}

TEST(RivalTables, TellTimesOverThatOfMres) {
  const ParetoPlane plane = paretoPlanes(reportOfRivals())[0];
  EXPECT_THAT(paretoRows(plane), Contains(ElementsAre("half-joint", "50.0", "0.0200", "0.300", "0.0400",
                                                      "0.000", "-", "-", "mres")));
  const auto rows = paretoRatioRows(plane);
  EXPECT_THAT(rows.front(),
              ElementsAre("technique", "at RMS 0.005", "at RMS 0.010", "at equal 99 % of blocks"));
  // full gets to an RMS of 0.01 with all its samples alone; at its 0.08, mres has no point any more.
  EXPECT_THAT(rows, Contains(ElementsAre("full", "not reached", "2.50", "not reached")));
  EXPECT_THAT(rows, Contains(ElementsAre("half-joint", "not reached", "not reached", "2.50")));
  EXPECT_EQ(rows.size(), 3U) << "none of mres itself";
}

TEST(RivalTables, AreMarkdownForDocuments) {
  EXPECT_THAT(paretoMarkdown(reportOfRivals()),
              AllOf(HasSubstr("**ssao 64, 1920x1080, 2 views**"),
                    HasSubstr("| technique | at RMS 0.005 | at RMS 0.010 | at equal 99 % of blocks |\n"
                              "| :-- | --: | --: | --: |\n"),
                    HasSubstr("| half-joint | 50.0 | 0.0200 |")));
}

TEST(Rivals, AreLeftOutOfWhatIsToldOfMresAlone) {
  const Json own = withoutRivals(reportOfRivals());
  ASSERT_EQ(own["results"].size(), 2U);
  for (const Json& result : own["results"]) {
    EXPECT_EQ(result["technique"], "mres");
    EXPECT_EQ(result["settings"]["errorBudget"], 0.01);
  }
}

TEST_F(Bench, RivalsHaveAPlotOfAnEffectAndSize) {
  const auto plots = drawPlots(reportOfRivals(), folder_);
  if (!plots) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(plots->front().file, "plots/pareto-ssao-64-1920x1080.svg");
  const std::string script = contentsOf(folder_ / "plots/pareto-ssao-64-1920x1080.gp");
  EXPECT_THAT(script, AllOf(HasSubstr("0.1 0.04\n0.4 0.01\n"), HasSubstr("title 'half-joint'")));
}

}  // namespace
}  // namespace host::test
