#include "host/measure/report.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "host/measure/report_table.h"
#include "host/measure/result_names.h"

namespace host {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Measurement example() {
  Measurement measurement;
  measurement.scene = "hall";
  measurement.triangles = 183333;
  measurement.camera = 2;
  measurement.cameraName = "Nave";
  measurement.size = {3840, 2160};
  measurement.effect = "ssao";
  measurement.samples = 64;
  measurement.technique = "mres";
  measurement.reference = "full";
  measurement.settings = {{"radius", 0.4}};
  InterleavedTimes times;
  for (const double jitter : {0.0, 1.0, -1.0, 0.5, -0.5, 0.0}) {
    times.technique.push_back({.wallMs = 100.0 + jitter});
    times.reference.push_back({.wallMs = 250.0 + jitter});
  }
  measurement.times = times;
  measurement.error = ErrorMetrics{.rms = 0.01,
                                   .max = 0.3,
                                   .psnr = 40.0,
                                   .ssim = 0.99,
                                   .nonFinite = 0,
                                   .blocks = {.max = 0.2, .percentile99 = 0.1, .worst = {12, 34}}};
  measurement.coverage = {0.04, 0.09, 0.2, 1.0};
  measurement.stages = {{"edges", 30.0}, {"level0", 70.0}};
  measurement.stagesClock = "glFinish+steady_clock";
  measurement.warnings = {"Something is left out."};
  measurement.plan = {.reason = "levels are faster",
                      .costs = mres::Costs{.shared = 1.0, .overhead = 2.0, .evaluation = 10.0, .work = 0.5}};
  measurement.skipped = {{"level1", "not used by this effect"}};
  measurement.gpuBytes = 123456;
  measurement.seconds = 46.4;
  return measurement;
}

Json reportOf(const std::vector<Measurement>& measurements) {
  Json report = makeReport({"llvmpipe", "4.5", 2});
  for (const Measurement& measurement : measurements) report["results"].push_back(toJson(measurement));
  return report;
}

TEST(Report, HasTheFieldsThatScriptsRelyOn) {
  const Json report = Json::parse(toText(reportOf({example()})));
  EXPECT_EQ(report["schema"], 1);
  EXPECT_TRUE(report["version"].is_string());
  EXPECT_TRUE(report["commit"].is_string());
  EXPECT_EQ(report["machine"].dump(), R"({"renderer":"llvmpipe","version":"4.5","cores":2})");
  const Json& result = report["results"][0];
  EXPECT_EQ(result["scene"], "hall");
  EXPECT_EQ(result["triangles"], 183333);
  EXPECT_EQ(result["camera"], 2);
  EXPECT_EQ(result["width"], 3840);
  EXPECT_EQ(result["height"], 2160);
  EXPECT_EQ(result["effect"], "ssao");
  EXPECT_EQ(result["samples"], 64);
  EXPECT_EQ(result["technique"], "mres");
  EXPECT_EQ(result["reference"], "full");
  EXPECT_EQ(result["time_ms"].dump(), R"({"median":100.0,"min":99.0,"max":101.0,"runs":6})");
  EXPECT_EQ(result["reference_time_ms"]["median"], 250.0);
  EXPECT_EQ(result["speedup"], 2.5);
  EXPECT_EQ(result["error"].dump(), R"({"rms":0.01,"max":0.3,"psnr":40.0,"ssim":0.99,"non_finite":0,)"
                                    R"("block_max":0.2,"block_p99":0.1,"worst_place":[12,34]})");
  EXPECT_EQ(result["coverage"].dump(), "[0.04,0.09,0.2,1.0]");
  EXPECT_DOUBLE_EQ(result["work"].get<double>(), 0.04 + 0.09 / 4.0 + 0.2 / 16.0 + 1.0 / 64.0);
  EXPECT_DOUBLE_EQ(result["floor_ms"].get<double>(), 250.0 * result["work"].get<double>());
  EXPECT_DOUBLE_EQ(result["efficiency"].get<double>(), 2.5 * result["work"].get<double>());
  EXPECT_EQ(result["stages_ms"].dump(), R"({"edges":30.0,"level0":70.0})");
  EXPECT_EQ(result["skipped"].dump(), R"([{"what":"level1","reason":"not used by this effect"}])");
  EXPECT_EQ(result["plan"]["reason"], "levels are faster");
  EXPECT_EQ(result["plan"]["falls_back"], false);
  EXPECT_NEAR(result["plan"]["levels_ms"].get<double>(), 8.0 * 3840 * 2160 * 1e-6, 1e-9);
  EXPECT_NEAR(result["plan"]["plain_ms"].get<double>(), 11.0 * 3840 * 2160 * 1e-6, 1e-9);
  EXPECT_EQ(result["stages_clock"], "glFinish+steady_clock");
  EXPECT_EQ(result["warnings"].dump(), R"(["Something is left out."])");
  EXPECT_EQ(result["gpu_bytes"], 123456);
  EXPECT_EQ(result["seconds"], 46.4);
  EXPECT_EQ(result["settings"]["radius"], 0.4);
}

TEST(Report, SaysWhichClockItsTimesAreOf) {
  Measurement measurement = example();
  EXPECT_EQ(toJson(measurement)["clock"], "glFinish+steady_clock");
  EXPECT_TRUE(toJson(measurement)["gpu_time_ms"].is_null());
  for (auto* runs : {&measurement.times->technique, &measurement.times->reference})
    for (RunTime& run : *runs) run = {run.wallMs, run.wallMs / 2.0, Clock::gpu};
  const Json result = toJson(measurement);
  EXPECT_EQ(result["clock"], "GL_TIME_ELAPSED");
  EXPECT_EQ(result["time_ms"]["median"], 50.0);
  EXPECT_EQ(result["wall_time_ms"]["median"], 100.0);
  EXPECT_EQ(result["gpu_time_ms"]["median"], 50.0);
}

TEST(Report, ClaimsNoEfficiencyWithoutCoverage) {
  Measurement measurement = example();
  measurement.coverage.clear();
  const Json result = toJson(measurement);
  EXPECT_EQ(result["speedup"], 2.5);
  for (const char* name : {"work", "floor_ms", "efficiency"}) EXPECT_TRUE(result[name].is_null()) << name;
}

TEST(Report, TellsTheWorkOfTechniquesWithoutLevels) {
  Measurement measurement = example();
  measurement.coverage.clear();
  measurement.work = 0.25;
  const Json result = toJson(measurement);
  EXPECT_EQ(result["coverage"], Json::array());
  EXPECT_EQ(result["work"], 0.25);
  EXPECT_EQ(result["floor_ms"], 62.5);
  EXPECT_EQ(result["efficiency"], 0.625);
}

TEST(Report, TellsTheSamplesOfTheReference) {
  Measurement measurement = example();
  EXPECT_EQ(toJson(measurement)["reference_samples"], measurement.samples);
  measurement.referenceSamples = 4 * measurement.samples;
  EXPECT_EQ(toJson(measurement)["reference_samples"], 4 * measurement.samples);
}

TEST(Report, WithoutTimingHasTheSameFieldsWithNull) {
  Measurement measurement = example();
  const Json timed = toJson(measurement);
  measurement.times.reset();
  const Json untimed = toJson(measurement);
  for (const auto& [key, value] : timed.items()) EXPECT_TRUE(untimed.contains(key)) << key;
  EXPECT_TRUE(untimed["time_ms"].is_null());
  EXPECT_TRUE(untimed["speedup"].is_null());
  EXPECT_TRUE(untimed["floor_ms"].is_null());
  EXPECT_FALSE(untimed["work"].is_null());
}

std::vector<TruthErrors> exampleTruths() {
  return {{"converged", "samples", 4096, 129600, {.rms = 0.03, .max = 0.6}, {.rms = 0.02, .max = 0.5}},
          {"ray_traced", "rays", 256, 32400, {.rms = 0.08, .max = 0.9}, {.rms = 0.07, .max = 0.8}}};
}

TEST(Report, HasTheErrorsAgainstEachTruth) {
  Measurement measurement = example();
  EXPECT_TRUE(toJson(measurement).at("truth").is_null());
  measurement.truths = exampleTruths();
  EXPECT_EQ(
      toJson(measurement)["truth"].dump(),
      R"({"converged":{"samples":4096,"pixels":129600,"rms":0.03,"max":0.6,"reference_rms":0.02,"reference_max":0.5},)"
      R"("ray_traced":{"rays":256,"pixels":32400,"rms":0.08,"max":0.9,"reference_rms":0.07,"reference_max":0.8}})");
}

TemporalErrors exampleFlicker() {
  return {.frames = 8,
          .rms = 0.004,
          .max = 0.25,
          .blockMax = 0.1,
          .blockPercentile99 = 0.02,
          .techniqueChange = 0.017,
          .referenceChange = 0.016};
}

TEST(Report, HasTheFlickerWhereItWasMeasured) {
  Measurement measurement = example();
  EXPECT_TRUE(toJson(measurement).at("temporal").is_null());
  measurement.temporal = exampleFlicker();
  EXPECT_EQ(toJson(measurement)["temporal"].dump(),
            R"({"frames":8,"rms":0.004,"max":0.25,"block_max":0.1,"block_p99":0.02,"change_rms":0.017,)"
            R"("reference_change_rms":0.016,"ratio":0.25,"non_finite":0})");
}

TEST(Report, WhereTheReferenceDoesNotChangeFlickerIsNoShareOfThat) {
  Measurement measurement = example();
  for (const double rms : {0.0, 0.004}) {
    measurement.temporal = TemporalErrors{.frames = 2, .rms = rms};
    EXPECT_TRUE(toJson(measurement)["temporal"]["ratio"].is_null()) << rms;
    EXPECT_THAT(toTemporalTable(reportOf({measurement})), HasSubstr("  -  ")) << rms;
  }
}

TEST(Report, AnInfinitePsnrIsNull) {
  Measurement measurement = example();
  measurement.error->psnr = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(toJson(measurement)["error"]["psnr"].is_null());
  EXPECT_THAT(toTable(reportOf({measurement})), Not(HasSubstr("inf")));
}

TEST(ReportTable, ShowsTheFiguresOfOneResult) {
  EXPECT_THAT(
      toTable(reportOf({example()})),
      AllOf(HasSubstr("hall"), HasSubstr("2.50x"), HasSubstr("0.0100"), HasSubstr("4.0 9.0 20.0 100.0"),
            HasSubstr("edges"), HasSubstr("30 %"), HasSubstr("6 interleaved pairs"), Not(HasSubstr("mean"))));
}

TEST(ReportTable, AveragesSeveralResults) {
  Measurement second = example();
  second.error->rms = 0.03;
  EXPECT_THAT(toTable(reportOf({example(), second})), AllOf(HasSubstr("mean"), HasSubstr("0.0200")));
}

TEST(ReportTable, AveragesNothingOfPicturesThatDifferInMoreThanTheirCameras) {
  Measurement second = example();
  second.size = {1920, 1080};
  EXPECT_THAT(toTable(reportOf({example(), second})), Not(HasSubstr("mean")));
}

TEST(ReportTable, SaysWhereThePlainEffectStoodIn) {
  Measurement second = example();
  EXPECT_THAT(toTable(reportOf({second})), Not(HasSubstr("stood in")));
  second.camera = 5;
  second.plan.fallsBack = true;
  EXPECT_THAT(
      toTable(reportOf({example(), second})),
      HasSubstr(
          "hall, camera 5, ssao, 3840x2160: the plain effect stood in for levels, which would take 66.4 ms"
          " instead of 91.2."));
}

TEST(ReportTable, ShowsStagesOfOneEffectAlone) {
  Measurement second = example();
  second.effect = "ssm";
  EXPECT_THAT(toTable(reportOf({example(), second})), Not(HasSubstr("stage by stage")));
}

/// Of a table with one row.
std::string cellBelow(const std::string& title, const Json& report) {
  const auto rows = tableRows(report);
  const auto column = std::ranges::find(rows.at(0), title) - rows.at(0).begin();
  return rows.at(1).at(column);
}

TEST(ReportTable, TellsHowWellASpeedupIsKnown) {
  const Json report = reportOf({example()});
  EXPECT_EQ(cellBelow("runs", report), "6");
  EXPECT_GT(std::stod(cellBelow("±%", report)), 0.0);
  EXPECT_LT(std::stod(cellBelow("±%", report)), 1.0);
  EXPECT_THAT(toTable(report), HasSubstr("with 95 % confidence"));
}

TEST(ReportTable, ClaimsNoIntervalOfAFewPairs) {
  Measurement measurement = example();
  measurement.times->technique.resize(1);
  measurement.times->reference.resize(1);
  const Json report = reportOf({measurement});
  EXPECT_EQ(cellBelow("runs", report), "1");
  EXPECT_EQ(cellBelow("±%", report), "-");
  EXPECT_THAT(toTable(report),
              AllOf(HasSubstr("Speedup 2.50x: 1 interleaved pair,"), Not(HasSubstr("95 %"))));
}

TEST(ReportNames, TellHowLongAllOfItTook) {
  EXPECT_EQ(durationOf(reportOf({example()})), "46 seconds");
  Measurement slow = example();
  slow.seconds = 83 * 60.0;
  EXPECT_EQ(durationOf(reportOf({example(), slow})), "84 minutes");
  Json older = reportOf({example()});
  older["results"][0].erase("seconds");
  EXPECT_EQ(durationOf(older), "");
}

TEST(ReportTable, DoesWithoutTheEfficiencyInOlderReports) {
  Json report = reportOf({example()});
  EXPECT_EQ(cellBelow("efficiency", report), "0.23");
  report["results"][0].erase("efficiency");
  EXPECT_EQ(cellBelow("efficiency", report), "-");
}

TEST(ReportTable, ShowsWhatWasNotMeasuredAsADash) {
  Measurement measurement = example();
  measurement.times.reset();
  measurement.stages.clear();
  EXPECT_THAT(toTable(reportOf({measurement})), AllOf(HasSubstr(" - "), HasSubstr("0.0100")));
}

TEST(TruthTable, HasALineForEachTruth) {
  Measurement measurement = example();
  EXPECT_EQ(toTruthTable(reportOf({measurement})), "");
  measurement.truths = exampleTruths();
  EXPECT_THAT(toTruthTable(reportOf({measurement})),
              AllOf(HasSubstr("hall 2 ssao"), HasSubstr("converged, 4096 samples  129600    0.0200  0.0300"),
                    HasSubstr("ray traced, 256 rays   32400    0.0700  0.0800")));
}

TEST(TemporalTable, HasALineForEachPictureWhoseFlickerWasMeasured) {
  Measurement measurement = example();
  EXPECT_EQ(toTemporalTable(reportOf({measurement})), "");
  measurement.temporal = exampleFlicker();
  const std::string table = toTemporalTable(reportOf({measurement, example(), measurement}));
  EXPECT_THAT(table,
              HasSubstr("hall 2 ssao               8         0.0160  0.0040       25.0          0.0200"));
  EXPECT_EQ(std::ranges::count(table, '\n'), 5);
}

TEST(TruthTable, DoesWithoutTheFieldInOlderReports) {
  Json report = reportOf({example()});
  report["results"][0].erase("truth");
  EXPECT_EQ(toTruthTable(report), "");
}

}  // namespace
}  // namespace host
