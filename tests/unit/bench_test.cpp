// What `mres bench` does with its results: keep them, go on from them, show them.
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <stdexcept>

#include "host/commands/bench_page.h"
#include "host/commands/bench_plots.h"
#include "host/commands/bench_results.h"
#include "host/commands/bench_summary.h"
#include "host/commands/bench_truth_summary.h"
#include "host/image/image_file.h"
#include "tests/support/temporary_folder.h"

namespace host {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

const Machine kMachine{"llvmpipe", "4.5", 2};

Measurement measurementOf(int camera, glm::ivec2 size, int samples) {
  Measurement measurement;
  measurement.scene = "hall <1>";
  measurement.camera = camera;
  measurement.size = size;
  measurement.effect = "ssao";
  measurement.samples = samples;
  measurement.technique = "mres";
  measurement.reference = "full";
  measurement.settings = {{"samples", samples}};
  measurement.times =
      InterleavedTimes{{{.wallMs = 10.0}, {.wallMs = 11.0}}, {{.wallMs = 20.0}, {.wallMs = 22.0}}};
  measurement.error = ErrorMetrics{.rms = 0.01, .max = 0.3, .psnr = 40.0, .ssim = 0.99, .nonFinite = 0};
  measurement.coverage = {0.1, 1.0};
  measurement.stages = {{"edges", 3.0}, {"level0", 7.0}};
  return measurement;
}

std::vector<TruthErrors> truthsOf(double reference, double technique) {
  return {
      {"converged", "samples", 4096, 100, {.rms = technique, .max = 0.6}, {.rms = reference, .max = 0.5}}};
}

std::string contentsOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Bench : public testing::Test {
 protected:
  [[nodiscard]] fs::path file() const { return folder_ / "results.json"; }
  void fillReport(BenchResults& results) {
    for (const int samples : {16, 64}) results.add(measurementOf(0, {1920, 1080}, samples));
    results.add(measurementOf(0, {3840, 2160}, 64));
  }

  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

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

TEST_F(Bench, WithoutResumingAllBeginsAnew) {
  { BenchResults(file(), kMachine, false).add(measurementOf(0, {64, 64}, 16)); }
  EXPECT_TRUE(BenchResults(file(), kMachine, false).report()["results"].empty());
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

/// A report of one result, spoilt by `spoil`, and what resuming from it says.
std::string refusalOf(const fs::path& file, const std::function<void(Json&)>& spoil) {
  BenchResults results(file, kMachine, false);
  results.add(measurementOf(0, {64, 64}, 16));
  Json report = results.report();
  spoil(report);
  std::ofstream(file) << report;
  try {
    const BenchResults resumed(file, kMachine, true);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(Bench, ResumingFromASoundReportIsNotRefused) {
  EXPECT_EQ(refusalOf(file(), [](Json&) {}), "");
  EXPECT_EQ(refusalOf(file(), [](Json& report) { report["results"][0]["error"]["psnr"] = nullptr; }), "");
  EXPECT_EQ(refusalOf(file(), [](Json& report) { report["results"][0].erase("truth"); }), "");
}

TEST_F(Bench, ResumingFromAReportThatLacksAFieldIsRefused) {
  for (const char* field : {"schema", "version", "commit", "machine", "results"})
    EXPECT_THAT(refusalOf(file(), [&](Json& report) { report.erase(field); }), HasSubstr("--resume"))
        << field;
  for (const char* field : {"scene", "camera", "width", "height", "effect", "samples", "technique", "time_ms",
                            "reference_time_ms", "clock", "speedup", "speedup_interval", "error", "coverage",
                            "stages_ms", "settings", "pictures"})
    EXPECT_THAT(refusalOf(file(), [&](Json& report) { report["results"][0].erase(field); }),
                HasSubstr(field));
  for (const char* field : {"time_ms", "reference_time_ms", "clock", "speedup_interval", "error"})
    EXPECT_THAT(refusalOf(file(), [&](Json& report) { report["results"][0][field] = nullptr; }),
                HasSubstr(field));
}

TEST_F(Bench, ResumingFromAFieldOfAnotherTypeIsRefused) {
  EXPECT_NE(refusalOf(file(), [](Json& report) { report["schema"] = "1"; }), "");
  EXPECT_NE(refusalOf(file(), [](Json& report) { report["results"] = Json::array({3}); }), "");
  for (const auto& [field, value] : std::map<std::string, Json>{{"scene", 1},
                                                                {"camera", "0"},
                                                                {"width", 1e300},
                                                                {"speedup", 0},
                                                                {"speedup_interval", {1.0}},
                                                                {"time_ms", {{"median", 1}}},
                                                                {"error", {{"rms", "0"}}},
                                                                {"coverage", {"all"}},
                                                                {"stages_ms", {{"edges", "fast"}}},
                                                                {"settings", 3},
                                                                {"pictures", {{"full", Json::array()}}}})
    EXPECT_THAT(refusalOf(file(), [&name = field,
                                   &broken = value](Json& report) { report["results"][0][name] = broken; }),
                HasSubstr("has a broken '" + field + "'"));
}

TEST_F(Bench, ResumingFromNoJsonIsRefused) {
  std::ofstream(file()) << "not JSON";
  EXPECT_THROW(BenchResults(file(), kMachine, true), std::runtime_error);
}

TEST_F(Bench, ResumingOnAnotherMachineOrByAnotherVersionIsRefused) {
  EXPECT_THAT(refusalOf(file(), [](Json& report) { report["machine"]["cores"] = 16; }),
              HasSubstr("another machine"));
  EXPECT_THAT(refusalOf(file(), [](Json& report) { report["version"] = "0.0.9"; }), HasSubstr("mres 0.0.9"));
  EXPECT_THAT(refusalOf(file(), [](Json& report) { report["commit"] = "abc"; }), HasSubstr("commit \"abc\""));
}

TEST_F(Bench, ResumingFromABrokenTruthIsRefused) {
  const auto refusalOfTruth = [&](const Json& truth) {
    return refusalOf(file(), [&](Json& report) { report["results"][0]["truth"] = truth; });
  };
  const Json whole{{"samples", 4096}, {"pixels", 100},        {"rms", 0.1},
                   {"max", 0.2},      {"reference_rms", 0.1}, {"reference_max", 0.2}};
  EXPECT_EQ(refusalOfTruth({{"converged", whole}}), "");
  for (const auto& [field, value] : whole.items()) {
    Json spoilt = whole;
    spoilt.erase(field);
    EXPECT_THAT(refusalOfTruth({{"converged", spoilt}}), HasSubstr("truth")) << field;
    spoilt[field] = "0.1";
    EXPECT_THAT(refusalOfTruth({{"converged", spoilt}}), HasSubstr("truth")) << field;
  }
  EXPECT_THAT(refusalOfTruth(3), HasSubstr("truth"));
}

TEST_F(Bench, PlotsAreDrawnFromTheReportAlone) {
  BenchResults results(file(), kMachine, false);
  fillReport(results);
  const auto plots = drawPlots(results.report(), folder_);
  if (!plots) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_THAT(*plots, testing::ElementsAre("plots/speedup-by-size.svg", "plots/speedup-by-samples.svg",
                                           "plots/error-against-time.svg", "plots/stages.svg"));
  for (const fs::path& plot : *plots)
    EXPECT_THAT(contentsOf(folder_ / plot), AllOf(HasSubstr("<svg"), HasSubstr("</svg>"))) << plot;
}

TEST_F(Bench, ManyViewsAreDrawnAsMeansAndBoxes) {
  BenchResults results(file(), kMachine, false);
  for (int camera = 0; camera < 13; ++camera) {
    for (const int samples : {16, 32, 64}) results.add(measurementOf(camera, {1920, 1080}, samples));
    results.add(measurementOf(camera, {3840, 2160}, 64));
  }
  const auto plots = drawPlots(results.report(), folder_);
  if (!plots) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_THAT(*plots,
              testing::ElementsAre("plots/mean-speedup-by-size.svg", "plots/mean-speedup-by-samples.svg",
                                   "plots/errors.svg", "plots/error-against-time.svg", "plots/stages.svg"));
  EXPECT_THAT(contentsOf(folder_ / "plots/mean-speedup-by-size.svg"),
              HasSubstr("ssao, 64 samples, 13 views"));
  EXPECT_THAT(contentsOf(folder_ / "plots/mean-speedup-by-samples.svg"),
              HasSubstr("ssao, 1920x1080, 13 views"));
  // The largest pictures that most views have.
  EXPECT_THAT(contentsOf(folder_ / "plots/errors.svg"), HasSubstr("3840x2160"));
}

/// A tiny picture under each name that a page shows.
Json picturesIn(const fs::path& folder) {
  Json pictures{{"difference_enhancement", 8.0}};
  for (const char* subject : {"full", "mres", "difference", "levels"}) {
    const std::string file = std::string(subject) + ".png";
    writeImage(folder / file, {{8, 4}, 3, std::vector<float>(8 * 4 * 3, 0.5f)});
    pictures[subject] = file;
  }
  return pictures;
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(Bench, ThePageHoldsAllThatItShows) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  results.add(measurementOf(1, {64, 64}, 16));
  std::ofstream(folder_ / "stages.svg") << "<svg/>";
  const std::string page = makePage(results.report(), {"stages.svg"}, folder_);
  EXPECT_THAT(page, AllOf(HasSubstr("hall &lt;1&gt;"), HasSubstr("2.00x"), HasSubstr("llvmpipe"),
                          HasSubstr(results.report()["version"].get<std::string>()),
                          HasSubstr(results.report()["commit"].get<std::string>()),
                          HasSubstr(results.report()["date"].get<std::string>()),
                          HasSubstr("difference, 8 times enhanced"), testing::Not(HasSubstr("hall <1>")),
                          testing::Not(HasSubstr("{{"))));
  EXPECT_EQ(countOf(page, "src=\"data:image/jpeg;base64,"), 3U);
  EXPECT_EQ(countOf(page, "src=\"data:image/png;base64,"), 1U);
  EXPECT_EQ(countOf(page, "src=\"data:image/svg+xml;base64,"), 1U);
  EXPECT_EQ(countOf(page, "src="), 5U) << "something is not in the page";
  EXPECT_EQ(countOf(page, "http:") + countOf(page, "https:") + countOf(page, "url("), 0U);
}

TEST_F(Bench, ThePageDoesWithoutPicturesThatAreGone) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  fs::remove(folder_ / "mres.png");
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  EXPECT_EQ(countOf(makePage(results.report(), {}, folder_), "src="), 0U);
}

TEST_F(Bench, ThePageIsWellFormed) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  std::string page = makePage(results.report(), {}, folder_);
  for (const std::string tag : {"html", "head", "body", "style", "script", "table", "thead", "tbody", "tr",
                                "td", "th", "figure", "div", "button", "details"})
    EXPECT_EQ(countOf(page, "<" + tag + ">") + countOf(page, "<" + tag + " "),
              countOf(page, "</" + tag + ">"))
        << tag;
}

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

Json reportWithTruths() {
  Json report = makeReport(kMachine);
  for (const int camera : {0, 1, 2}) {
    Measurement measurement = measurementOf(camera, {64, 64}, 16);
    if (camera < 2) measurement.truths = truthsOf(0.01 + 0.02 * camera, 0.02 + 0.02 * camera);
    report["results"].push_back(toJson(measurement));
  }
  return report;
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

TEST_F(Bench, ThePageTellsTruthsWhereThereAreSome) {
  EXPECT_THAT(makePage(reportWithTruths(), {}, folder_),
              AllOf(HasSubstr("Against the truth"), HasSubstr("+50.0 %"), HasSubstr("loses nothing")));
  BenchResults results(file(), kMachine, false);
  fillReport(results);
  EXPECT_THAT(makePage(results.report(), {}, folder_), testing::Not(HasSubstr("Against the truth")));
}

}  // namespace
}  // namespace host
