// `mres bench`: campaigns, their reports, and what is left out of them.
#include <algorithm>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/command_support.h"
#include "tests/cli/process.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

TEST_F(Command, BenchWritesACampaignAndResumesIt) {
  const std::vector<std::string> arguments{"bench",   "--suite", "quick",          "-o", folder_ / "not-here",
                                           "--suite", "smoke",   "--repeat",       "2",  "--resume",
                                           "--json",  "-o",      folder_ / "bench"};
  const ProcessResult first = runMres(arguments);
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const std::string file = readFile(folder_.path() / "bench/results.json");
  const json report = json::parse(first.out);
  EXPECT_EQ(report, json::parse(file));
  std::vector<std::string> effects;
  for (const json& result : report["results"]) {
    effects.push_back(result["effect"]);
    EXPECT_EQ(result["scene"], "office");
    EXPECT_EQ(result["time_ms"]["runs"], 2);
    EXPECT_GT(result["seconds"], 0.0);
  }
  EXPECT_THAT(effects, testing::ElementsAre("ssao", "ssao", "ssm", "ssgi"));
  for (const char* subject : {"mres", "worst_full", "worst_mres", "worst_effect_mres"})
    EXPECT_TRUE(
        fs::exists(folder_.path() / "bench" / report["results"][0]["pictures"][subject].get<std::string>()))
        << subject;
  const std::string page = readFile(folder_.path() / "bench/report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("data:image/jpeg"), HasSubstr("Against the truth"),
                          HasSubstr("Worst places"), HasSubstr("</html>")));
  if (first.err.empty()) {  // else it says that there is no gnuplot
    EXPECT_THAT(filesBelow("bench/plots"), testing::Contains("speedup-by-size.svg"));
  }

  const ProcessResult second = runMres(arguments);
  EXPECT_EQ(second.out, first.out);
  const bool isOfChangedFiles = report["commit"].get<std::string>().ends_with('+');
  EXPECT_EQ(second.err.starts_with("mres: note: Files were changed"), isOfChangedFiles) << second.err;
  EXPECT_EQ(readFile(folder_.path() / "bench/results.json"), file) << "something was measured again";
}

TEST_F(Command, BenchOfRivalsHasTimeAgainstErrorAndResumes) {
  const fs::path output = folder_.path() / "bench";
  const std::vector<std::string> arguments{
      "bench",    "--suite", "pareto-smoke", "--scenes", scene_,
      "--repeat", "1",       "--resume",     "-o",       output.string()};
  EXPECT_THAT(succeed(arguments), AllOf(HasSubstr("ssao 8, 64x36, 1 view"), HasSubstr("dominated by")));
  const std::string file = readFile(output / "results.json");
  const json results = json::parse(file)["results"];
  ASSERT_EQ(results.size(), 4U);
  for (const json& result : results) {
    EXPECT_EQ(result["reference_samples"], 8);
    EXPECT_TRUE(result["coverage"].empty()) << "stages cost frames";
    EXPECT_GT(result["gpu_bytes"], 0);
  }
  for (const int rival : {2, 3})  // mres may fall back to the plain effect
    EXPECT_GT(results[rival]["error"]["rms"], 0.0) << results[rival]["technique"];
  // So small a picture may fall back, and then there is no flicker of levels.
  if (!results[0]["plan"].is_null() && results[0]["plan"]["falls_back"] == true)
    EXPECT_TRUE(results[0]["temporal"].is_null());
  else
    EXPECT_EQ(results[0]["temporal"]["frames"], 2);
  EXPECT_GT(results[0]["truth"]["converged"]["reference_rms"], 0.0);
  EXPECT_GT(results[1]["settings"]["errorBudget"], results[0]["settings"]["errorBudget"]);
  EXPECT_EQ(results[2]["technique"], "half-joint");
  EXPECT_EQ(results[3]["technique"], "full");
  EXPECT_EQ(results[3]["samples"], 2);
  EXPECT_THAT(readFile(output / "report.html"), HasSubstr("<h2>Time against error</h2>"));
  EXPECT_THAT(readFile(output / "pareto.md"), HasSubstr("| full, 2 samples |"));
  EXPECT_EQ(runMres(arguments).exitCode, 0);
  EXPECT_EQ(readFile(output / "results.json"), file) << "something was measured again";
}

TEST_F(Command, BenchReportsWhatIsThereWithoutMeasuring) {
  const fs::path output = folder_.path() / "bench";
  ASSERT_THAT(
      succeed({"bench", "--suite", "smoke", "--scenes", scene_, "--no-timing", "-o", output.string()}),
      HasSubstr("Measured in "));
  const std::string results = readFile(output / "results.json");
  const std::string page = readFile(output / "report.html");
  fs::remove(output / "report.html");
  const ProcessResult again = runMres({"bench", "--report", "--json", "-o", output.string()},
                                      {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"});
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_EQ(again.out, results);
  EXPECT_EQ(readFile(output / "results.json"), results);
  EXPECT_EQ(readFile(output / "report.html"), page);
}

TEST_F(Command, BenchKeepsResultsThatItIsNotToldToResume) {
  const fs::path output = folder_.path() / "bench";
  const std::vector<std::string> arguments{"bench", "--suite",     "smoke", "--scenes",
                                           scene_,  "--no-timing", "-o",    output.string()};
  succeed(arguments);
  const std::string results = readFile(output / "results.json");
  EXPECT_THAT(runMres(arguments).err, AllOf(HasSubstr("results.previous.json"), testing::EndsWith("'.\n")));
  EXPECT_EQ(readFile(output / "results.previous.json"), results);
}

TEST_F(Command, BenchLeavesOutWhatItCannotMeasure) {
  const fs::path output = folder_.path() / "bench";
  writeFile(folder_.path() / "scenes/good.gltf", readFile(scene_));
  writeFile(folder_.path() / "scenes/broken.glb", "");
  const ProcessResult result = runMres(
      {"bench", "--suite", "smoke", "--scenes", folder_ / "scenes", "--no-timing", "-o", output.string()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, AllOf(HasSubstr("broken.glb"), testing::EndsWith("reasons above, of: broken.\n")));
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 2) << result.err;
  const json results = json::parse(readFile(output / "results.json"))["results"];
  EXPECT_EQ(results.size(), 4U);
  for (const json& each : results) EXPECT_EQ(each["scene"], "good");
  EXPECT_TRUE(fs::exists(output / "report.html"));
}

TEST_F(Command, BenchOfNothingButBrokenScenesLeavesNothing) {
  writeFile(folder_.path() / "broken.glb", "");
  const ProcessResult result =
      runMres({"bench", "--suite", "smoke", "--scenes", folder_ / "broken.glb", "-o", folder_ / "bench"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::EndsWith("\nmres: Nothing could be measured.\n"));
  EXPECT_FALSE(fs::exists(folder_.path() / "bench"));
}

}  // namespace
}  // namespace host::test
