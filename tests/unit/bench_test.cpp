// What `mres bench` does with its results: keep them, go on from them, show them.
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <stdexcept>
#include <unistd.h>

#include "host/commands/bench_page.h"
#include "host/commands/bench_plots.h"
#include "host/commands/bench_results.h"

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

class Bench : public testing::Test {
 protected:
  Bench() : folder_(fs::temp_directory_path() / ("mres-bench-test-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Bench() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
  Bench(Bench&&) = delete;
  Bench& operator=(Bench&&) = delete;

  [[nodiscard]] fs::path file() const { return folder_ / "results.json"; }
  void fillReport(BenchResults& results) {
    for (const int samples : {16, 64}) results.add(measurementOf(0, {1920, 1080}, samples));
    results.add(measurementOf(0, {3840, 2160}, 64));
  }

  fs::path folder_;
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
  EXPECT_TRUE(resumed.contains(measurementOf(0, {1920, 1080}, 16), true));
  EXPECT_FALSE(resumed.contains(measurementOf(1, {1920, 1080}, 16), true));
  EXPECT_FALSE(resumed.contains(measurementOf(0, {1920, 1080}, 32), true));
  Measurement changed = measurementOf(0, {1920, 1080}, 16);
  changed.settings["radius"] = 2.0;
  EXPECT_FALSE(resumed.contains(changed, true));
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
  EXPECT_TRUE(resumed.contains(untimed, false));
  EXPECT_FALSE(resumed.contains(untimed, true));
  resumed.add(measurementOf(0, {64, 64}, 16));
  EXPECT_EQ(resumed.report()["results"].size(), 1U);
  EXPECT_TRUE(resumed.contains(untimed, true));
  EXPECT_TRUE(resumed.contains(untimed, false));
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
}

TEST_F(Bench, ResumingFromAReportThatLacksAFieldIsRefused) {
  for (const char* field : {"schema", "version", "machine", "results"})
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
    EXPECT_THAT(refusalOf(file(), [&](Json& report) { report["results"][0][field] = value; }),
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
}

TEST_F(Bench, PlotsAreDrawnFromTheReportAlone) {
  BenchResults results(file(), kMachine, false);
  fillReport(results);
  const auto plots = drawPlots(results.report(), folder_);
  if (!plots) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_THAT(*plots, testing::ElementsAre("plots/speedup-by-size.svg", "plots/speedup-by-samples.svg",
                                           "plots/error-against-time.svg", "plots/stages.svg"));
  for (const fs::path& plot : *plots) {
    std::ifstream stream(folder_ / plot);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_THAT(text, AllOf(HasSubstr("<svg"), HasSubstr("</svg>"))) << plot;
  }
}

TEST_F(Bench, ThePageShowsTablePlotsAndPicturesWithNamesEscaped) {
  Measurement measurement = measurementOf(0, {64, 64}, 16);
  measurement.pictures = {{"full", "pictures/full.png"}};
  BenchResults results(file(), kMachine, false);
  results.add(measurement);
  EXPECT_THAT(makePage(results.report(), {"plots/stages.svg"}),
              AllOf(HasSubstr("hall &lt;1>"), HasSubstr("2.00x"), HasSubstr("plots/stages.svg"),
                    HasSubstr("pictures/full.png"), testing::Not(HasSubstr("hall <1>"))));
}

}  // namespace
}  // namespace host
