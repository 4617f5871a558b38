// What `mres bench` does with its results: keep them, go on from them, show them.
#include <cstdlib>
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
using testing::ElementsAre;
using testing::HasSubstr;

const Machine kMachine{"llvmpipe", "4.5", 2};

Measurement measurementOf(int camera, glm::ivec2 size, int samples) {
  Measurement measurement;
  measurement.scene = "hall <1>";
  measurement.cameraName = "nave";
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

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
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
  fs::remove(file);
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
  for (const char* later : {"truth", "seconds", "warnings"})
    EXPECT_EQ(refusalOf(file(), [&](Json& report) { report["results"][0].erase(later); }), "") << later;
  EXPECT_EQ(refusalOf(file(), [](Json& report) { report.erase("date"); }), "");
}

TEST_F(Bench, ResumingFromAReportThatLacksAFieldIsRefused) {
  for (const char* field : {"schema", "version", "commit", "machine", "results"})
    EXPECT_THAT(refusalOf(file(), [&](Json& report) { report.erase(field); }), HasSubstr("--resume"))
        << field;
  for (const char* field : {"scene", "triangles", "camera", "camera_name", "width", "height", "effect",
                            "samples", "technique", "time_ms", "reference_time_ms", "clock", "speedup",
                            "speedup_interval", "error", "coverage", "stages_ms", "settings", "pictures"})
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
                                                                {"seconds", "1"},
                                                                {"warnings", "lost"},
                                                                {"pictures", {{"full", 3}}}})
    EXPECT_THAT(refusalOf(file(), [&name = field,
                                   &broken = value](Json& report) { report["results"][0][name] = broken; }),
                HasSubstr("has a broken '" + field + "'"));
}

TEST_F(Bench, ResumingFromABrokenHeadIsRefused) {
  EXPECT_THAT(refusalOf(file(), [](Json& report) { report["date"] = 3; }), HasSubstr("date"));
  EXPECT_THAT(refusalOf(file(), [](Json& report) { report["machine"].erase("renderer"); }),
              HasSubstr("names no machine"));
}

TEST_F(Bench, PicturesAreFilesAndOneFactor) {
  const auto refusalOfPictures = [&](const Json& pictures) {
    return refusalOf(file(), [&](Json& report) { report["results"][0]["pictures"] = pictures; });
  };
  EXPECT_EQ(refusalOfPictures({{"full", "full.png"}, {"difference_enhancement", 8.0}}), "");
  EXPECT_THAT(refusalOfPictures({{"difference_enhancement", "8"}}), HasSubstr("pictures"));
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

std::vector<std::string> namesOf(const std::vector<Plot>& plots) {
  std::vector<std::string> names;
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

/// A tiny picture under each name that a page shows.
Json picturesIn(const fs::path& folder) {
  Json pictures{{"difference_enhancement", 8.0}};
  for (const char* subject : {"full", "mres", "effect_full", "effect_mres", "difference", "levels"}) {
    const std::string file = std::string(subject) + ".png";
    writeImage(folder / file, {{8, 4}, 3, std::vector<float>(8 * 4 * 3, 0.5f)});
    pictures[subject] = file;
  }
  return pictures;
}

TEST_F(Bench, ThePageHoldsAllThatItShows) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  results.add(measurementOf(1, {64, 64}, 16));
  std::ofstream(folder_ / "stages.svg") << "<svg/>";
  const std::string page = makePage(results.report(), {Plot{"stages.svg", "Where the time goes"}}, folder_);
  EXPECT_THAT(page, AllOf(HasSubstr("hall &lt;1&gt;"), HasSubstr("2.00x"), HasSubstr("llvmpipe"),
                          HasSubstr(results.report()["version"].get<std::string>()),
                          HasSubstr(results.report()["commit"].get<std::string>()),
                          HasSubstr(results.report()["date"].get<std::string>()),
                          HasSubstr("difference, 8 times enhanced"), HasSubstr("alt=\"Where the time goes\""),
                          testing::Not(HasSubstr("hall <1>")), testing::Not(HasSubstr("{{"))));
  EXPECT_EQ(countOf(page, "src=\"data:image/jpeg;base64,"), 5U);
  EXPECT_EQ(countOf(page, "src=\"data:image/png;base64,"), 1U);
  EXPECT_EQ(countOf(page, "src=\"data:image/svg+xml;base64,"), 1U);
  EXPECT_EQ(countOf(page, "src="), 7U) << "something is not in the page";
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

/// As XML, but for its script: that is no markup.
TEST_F(Bench, ThePageIsWellFormed) {
  if (std::system("command -v python3 > /dev/null") != 0) GTEST_SKIP() << "python3 is not installed";
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = picturesIn(folder_);
  measurement.truths = truthsOf(0.02, 0.03);
  measurement.warnings = {"Texture <7> & others are left out."};
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  std::string page = makePage(results.report(), {}, folder_);
  const std::size_t script = page.find("<script>");
  page.erase(script, page.find("</body>") - script);
  std::ofstream(folder_ / "page.xml") << page;
  EXPECT_EQ(std::system(("python3 -c 'import sys, xml.dom.minidom as dom; dom.parse(sys.argv[1])' '" +
                         (folder_ / "page.xml").string() + "'")
                            .c_str()),
            0);
}

TEST_F(Bench, ThePageNamesThePictureWithTheGreatestError) {
  Json report = makeReport(kMachine);
  for (const int camera : {0, 1}) report["results"].push_back(toJson(measurementOf(camera, {64, 64}, 16)));
  report["results"][1]["error"]["rms"] = 0.0251;
  EXPECT_THAT(makePage(report, {}, folder_),
              HasSubstr("The greatest RMS is 0.0251, of hall &lt;1&gt; 1, ssao, 16 samples, 64x64."));
  report["results"][1]["error"] = nullptr;
  EXPECT_THAT(makePage(report, {}, folder_),
              HasSubstr("The greatest RMS is 0.0100, of hall &lt;1&gt; 0, ssao, 16 samples, 64x64."));
  report["results"][0]["error"] = nullptr;
  EXPECT_THAT(makePage(report, {}, folder_), testing::Not(HasSubstr("The greatest RMS")));
}

TEST_F(Bench, ThePageTellsHowWellSpeedupsAreKnown) {
  Json report = makeReport(kMachine);
  report["results"].push_back(toJson(measurementOf(0, {64, 64}, 16)));
  EXPECT_THAT(makePage(report, {}, folder_),
              AllOf(HasSubstr("<p>" + speedupCertainty(report) + "</p>"), HasSubstr(">±%<")));
  Measurement untimed = measurementOf(0, {64, 64}, 16);
  untimed.times.reset();
  report["results"] = Json::array({toJson(untimed)});
  EXPECT_THAT(makePage(report, {}, folder_), testing::Not(HasSubstr("The speedup is known")));
}

TEST_F(Bench, ThePageTellsWhatScenesLackOnce) {
  Json report = makeReport(kMachine);
  EXPECT_THAT(makePage(report, {}, folder_), testing::Not(HasSubstr("What the scenes lack")));
  for (const int camera : {0, 1}) {
    Measurement measurement = measurementOf(camera, {64, 64}, 16);
    measurement.warnings = {"A light is left out."};
    report["results"].push_back(toJson(measurement));
  }
  const std::string page = makePage(report, {}, folder_);
  EXPECT_THAT(page, HasSubstr("What the scenes lack"));
  EXPECT_EQ(countOf(page, "A light is left out."), 1U);
}

TEST_F(Bench, ThePageTellsHowLongItTook) {
  Json report = makeReport(kMachine);
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.seconds = 300.0;
  report["results"].push_back(toJson(measurement));
  EXPECT_THAT(makePage(report, {}, folder_), HasSubstr("measured in 5 minutes"));
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
