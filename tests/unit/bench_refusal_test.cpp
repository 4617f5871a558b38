// The reports that `mres bench --resume` refuses to go on from.
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <stdexcept>
#include <string>

#include "host/bench/results.h"
#include "host/measure/picture_names.h"
#include "tests/unit/bench_support.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

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
                                                                {"pictures", {{kFullPicture, 3}}}})
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
  EXPECT_EQ(refusalOfPictures({{kFullPicture, "full.png"}, {kDifferenceEnhancementName, 8.0}}), "");
  EXPECT_THAT(refusalOfPictures({{kDifferenceEnhancementName, "8"}}), HasSubstr("pictures"));
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

}  // namespace
}  // namespace host::test
