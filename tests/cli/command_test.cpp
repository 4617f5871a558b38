#include <algorithm>
#include <chrono>
#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

#include "host/image/image_file.h"
#include "tests/cli/process.h"

namespace host::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

class Command : public testing::Test {
 protected:
  std::string succeed(const std::vector<std::string>& arguments) {
    const ProcessResult result = runMres(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result.out;
  }
  /// The one result of a small comparison without times.
  json untimedComparison(const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"compare", scene_,        "--size", "64x36", "--samples",
                                       "8",       "--no-timing", "--json", "-o",    folder_ / "out"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return json::parse(succeed(arguments))["results"].at(0);
  }
  [[nodiscard]] std::vector<std::string> filesBelow(const std::string& name) const {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / name))
      if (entry.is_regular_file())
        files.push_back(fs::relative(entry.path(), folder_.path() / name).string());
    std::ranges::sort(files);
    return files;
  }

  TemporaryFolder folder_;
  std::string scene_ = writeCornerScene(folder_);
};

TEST_F(Command, WithoutArgumentsTeaches) {
  EXPECT_THAT(succeed({}),
              AllOf(HasSubstr("mres compare hall"), HasSubstr("render"), HasSubstr("Exit codes")));
  EXPECT_EQ(succeed({"--help"}), succeed({}));
}

TEST_F(Command, HelpListsEverySettingOfAReport) {
  const json settings = untimedComparison({})["settings"];
  EXPECT_GE(settings.size(), 10U);
  for (const char* command : {"compare", "render"}) {
    const std::string help = succeed({command, "--help"});
    EXPECT_THAT(help, AllOf(HasSubstr("Examples"), HasSubstr("degrees")));
    for (const auto& [name, value] : settings.items())
      EXPECT_THAT(help, HasSubstr("\n  " + name + "=")) << command;
  }
}

TEST_F(Command, SaysItsVersion) {
  EXPECT_EQ(succeed({"--version"}), "mres " MRES_VERSION "\n");
  EXPECT_EQ(json::parse(succeed({"info", "--json"}))["version"], MRES_VERSION);
}

TEST_F(Command, TheLastOfAnOptionGivenTwiceCounts) {
  const json report = json::parse(succeed({"render",   scene_,
                                           "--size",   "8x8",
                                           "--size",   "16x9",
                                           "--camera", "0",
                                           "--camera", "1",
                                           "--json",   "--json",
                                           "--repeat", "5",
                                           "--repeat", "2",
                                           "-o",       folder_ / "a.png",
                                           "-o",       folder_ / "b.png"}));
  const json& result = report["results"][0];
  EXPECT_EQ(result["width"], 16);
  EXPECT_EQ(result["camera"], 1);
  EXPECT_EQ(result["time_ms"]["runs"], 2);
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
  EXPECT_TRUE(fs::exists(folder_ / "b.png"));
}

TEST_F(Command, InfoNamesDeviceScenesEffectsAndTechniques) {
  EXPECT_THAT(succeed({"info"}),
              AllOf(HasSubstr("OpenGL"), HasSubstr("office, hall, breakfast"), HasSubstr("ssao")));
}

TEST_F(Command, InfoAsJson) {
  const json info = json::parse(succeed({"info", "--json"}));
  EXPECT_EQ(info["schema"], 1);
  EXPECT_GT(info["machine"]["cores"], 0);
  EXPECT_FALSE(info["machine"]["renderer"].get<std::string>().empty());
  EXPECT_EQ(info["scenes"], json({"office", "hall", "breakfast"}));
  EXPECT_EQ(info["techniques"], json({"full", "mres"}));
  EXPECT_EQ(info["effects"], json({"ssao", "ssm", "ssgi"}));
  EXPECT_GE(info["limits"]["texture_size"], 1024);
}

TEST_F(Command, RenderWritesAPicture) {
  succeed({"render", scene_, "--size", "97x41", "-o", folder_ / "a.png"});
  const FloatImage picture = readImage(folder_ / "a.png");
  EXPECT_EQ(picture.size, glm::ivec2(97, 41));
  EXPECT_GT(std::ranges::max(picture.pixels), 0.1f);
}

TEST_F(Command, RenderWritesLinearRadianceAsExr) {
  succeed({"render", scene_, "--size", "97x41", "--effect", "none", "-o", folder_ / "a.exr"});
  EXPECT_EQ(readImage(folder_ / "a.exr").size, glm::ivec2(97, 41));
}

TEST_F(Command, RenderTakesEndingsInCapitals) {
  succeed({"render", scene_, "--size", "8x8", "-o", folder_ / "a.PNG"});
  EXPECT_EQ(readImage(folder_ / "a.PNG").size, glm::ivec2(8, 8));
}

TEST_F(Command, RenderOfOnePixel) {
  for (const char* technique : {"full", "mres"})
    succeed({"render", scene_, "--size", "1x1", "--technique", technique, "-o", folder_ / "a.png"});
}

TEST_F(Command, RenderIsTheSameEveryTime) {
  for (const char* name : {"a.exr", "b.exr"})
    succeed({"render", scene_, "--size", "64x36", "-o", folder_ / name});
  EXPECT_EQ(readImage(folder_ / "a.exr").pixels, readImage(folder_ / "b.exr").pixels);
}

TEST_F(Command, RenderTimesTheEffectAlone) {
  const json report = json::parse(
      succeed({"render", scene_, "--size", "64x36", "--repeat", "3", "--json", "-o", folder_ / "a.png"}));
  const json& result = report["results"][0];
  EXPECT_EQ(result["scene"], "corner");
  EXPECT_EQ(result["time_ms"]["runs"], 3);
  EXPECT_TRUE(result["speedup"].is_null());
  EXPECT_FALSE(result["stages_ms"].empty());
  EXPECT_FALSE(result["stages_clock"].is_null());
}

TEST_F(Command, RenderTimesUntilTheMedianIsKnown) {
  const json report =
      json::parse(succeed({"render", scene_, "--size", "64x36", "--json", "-o", folder_ / "a.png"}));
  EXPECT_GE(report["results"][0]["time_ms"]["runs"], 5);
}

TEST_F(Command, RenderTimesOnlyWhatIsAskedFor) {
  const std::string picture = folder_ / "a.png";
  EXPECT_EQ(succeed({"render", scene_, "--size", "64x36", "-o", picture}), picture + "\n");
  EXPECT_EQ(succeed({"render", scene_, "--size", "64x36", "--no-timing", "-o", picture}), picture + "\n");
  EXPECT_THAT(
      succeed({"render", scene_, "--size", "64x36", "--repeat", "2", "-o", picture}),
      testing::MatchesRegex(picture + "\nssao by mres: .* ms, the median of 2 runs from .* ms \\(.*\\)\n"));
}

TEST_F(Command, RenderWithoutTimingReportsAllElse) {
  const json report = json::parse(
      succeed({"render", scene_, "--size", "64x36", "--no-timing", "--json", "-o", folder_ / "a.png"}));
  const json& result = report["results"][0];
  EXPECT_TRUE(result["time_ms"].is_null());
  EXPECT_TRUE(result["stages_ms"].empty());
  EXPECT_TRUE(result["stages_clock"].is_null());
  EXPECT_EQ(result["coverage"].back(), 1.0);
  EXPECT_GT(result["gpu_bytes"], 0);
}

TEST_F(Command, CompareReportsEveryFieldOfTheSchema) {
  const json report =
      json::parse(succeed({"compare", scene_, "--camera", "1", "--size", "160x90", "--samples", "8",
                           "--repeat", "3", "--json", "-o", folder_ / "out"}));
  EXPECT_EQ(report, json::parse(readFile(folder_.path() / "out/report.json")));
  EXPECT_EQ(report["schema"], 1);
  for (const char* key : {"renderer", "version", "cores"})
    EXPECT_TRUE(report["machine"].contains(key)) << key;
  ASSERT_EQ(report["results"].size(), 1U);
  const json& result = report["results"][0];
  EXPECT_EQ(result["triangles"], 4);
  EXPECT_EQ(result["camera"], 1);
  EXPECT_EQ(result["width"], 160);
  EXPECT_EQ(result["height"], 90);
  EXPECT_EQ(result["effect"], "ssao");
  EXPECT_EQ(result["samples"], 8);
  EXPECT_EQ(result["technique"], "mres");
  EXPECT_EQ(result["reference"], "full");
  for (const char* key : {"time_ms", "reference_time_ms"}) {
    EXPECT_EQ(result[key]["runs"], 3) << key;
    EXPECT_LE(result[key]["min"], result[key]["median"]) << key;
    EXPECT_LE(result[key]["median"], result[key]["max"]) << key;
  }
  EXPECT_DOUBLE_EQ(result["speedup"].get<double>(), result["reference_time_ms"]["median"].get<double>() /
                                                        result["time_ms"]["median"].get<double>());
  EXPECT_LE(result["error"]["rms"], result["error"]["max"]);
  EXPECT_LT(result["error"]["rms"], 0.1);
  EXPECT_TRUE(result["error"].contains("psnr"));
  EXPECT_GT(result["error"]["ssim"], 0.8);
  EXPECT_EQ(result["error"]["non_finite"], 0);
  EXPECT_TRUE(result.at("truth").is_null());
  EXPECT_EQ(result["coverage"].back(), 1.0);
  EXPECT_TRUE(result["stages_ms"].contains("composite"));
  EXPECT_TRUE(result["skipped"].is_array());
  EXPECT_GT(result["gpu_bytes"], 0);
  EXPECT_EQ(result["settings"]["samples"], 8);
}

TEST_F(Command, CompareMeasuresAgainstTruthWhereAsked) {
  const json truth = untimedComparison({"--truth"})["truth"];
  EXPECT_GE(truth.at("converged").at("samples"), 4096);
  EXPECT_EQ(truth.at("converged").at("pixels"), 12 * 16);  // of the 144 blocks of 4x4, one in fifteen
  EXPECT_EQ(truth.at("ray_traced").at("rays"), 256);
  EXPECT_EQ(truth.at("ray_traced").at("pixels"), 64 * 36);
  for (const json& errors : truth) {
    EXPECT_GT(errors.at("rms"), 0.0);
    EXPECT_LE(errors.at("rms"), errors.at("max"));
    EXPECT_LE(errors.at("reference_rms"), errors.at("reference_max"));
    EXPECT_LT(errors.at("reference_rms"), 0.2);
  }
}

TEST_F(Command, CompareSaysHowFarBothAreFromTheTruth) {
  EXPECT_THAT(
      succeed({"compare", scene_, "--size", "64x36", "--no-timing", "--truth", "-o", folder_ / "out"}),
      AllOf(HasSubstr("converged, 4096 samples"), HasSubstr("ray traced, 256 rays")));
}

TEST_F(Command, CompareWritesItsPicturesAndNothingElse) {
  EXPECT_THAT(succeed({"compare", scene_, "--size", "96x54", "--no-timing", "-o", folder_ / "out"}),
              HasSubstr("RMS"));
  EXPECT_THAT(filesBelow("out"), testing::ElementsAre("difference.png", "edges.png", "effect_full.exr",
                                                      "effect_full.png", "effect_mres.exr", "effect_mres.png",
                                                      "full.png", "levels.png", "mres.png", "report.json"));
  for (const std::string& file : filesBelow("out")) {
    if (file == "report.json") continue;
    EXPECT_EQ(readImage(folder_.path() / "out" / file).size, glm::ivec2(96, 54)) << file;
  }
}

TEST_F(Command, CompareOfAllCamerasKeepsTheirPicturesApart) {
  const json report = json::parse(succeed({"compare", scene_, "--camera", "all", "--size", "64x36",
                                           "--no-timing", "--json", "-o", folder_ / "out"}));
  ASSERT_EQ(report["results"].size(), 2U);
  for (const json& result : report["results"])
    EXPECT_TRUE(fs::exists(folder_.path() / "out" / result["pictures"]["mres"].get<std::string>()));
  EXPECT_NE(report["results"][0]["pictures"]["mres"], report["results"][1]["pictures"]["mres"]);
}

TEST_F(Command, FullComparedWithItselfHasNoError) {
  const json report = json::parse(succeed({"compare", scene_, "--technique", "full", "--size", "64x36",
                                           "--no-timing", "--json", "-o", folder_ / "out"}));
  const json& error = report["results"][0]["error"];
  EXPECT_EQ(error["rms"], 0.0);
  EXPECT_TRUE(error["psnr"].is_null());
}

TEST_F(Command, SettingsReachThePicture) {
  const auto rmsWith = [&](const std::string& setting) {
    const json report =
        json::parse(succeed({"compare", scene_, "--set", setting, "--set", "samples=16", "--size", "160x90",
                             "--no-timing", "--json", "-o", folder_ / "out"}));
    EXPECT_EQ(report["results"][0]["settings"]["samples"], 16);
    return report["results"][0]["error"]["rms"].get<double>();
  };
  EXPECT_EQ(rmsWith("intensity=0"), 0.0);
  EXPECT_GT(rmsWith("intensity=1"), 0.0);
}

TEST_F(Command, WithoutTimingNoStageIsTimed) {
  const json result = untimedComparison({});
  EXPECT_TRUE(result["stages_ms"].empty());
  EXPECT_TRUE(result["stages_clock"].is_null());
  EXPECT_EQ(result["coverage"].back(), 1.0);
  EXPECT_LT(result["coverage"].front(), 1.0);
  EXPECT_GT(result["gpu_bytes"], 0);
}

TEST_F(Command, TheSeedChoosesThePoints) {
  const json first = untimedComparison({"--seed", "1"});
  const json second = untimedComparison({"--seed", "2"});
  EXPECT_EQ(first["settings"]["seed"], 1);
  EXPECT_EQ(second["settings"]["seed"], 2);
  EXPECT_NE(first["error"]["rms"], second["error"]["rms"]);
}

TEST_F(Command, TheShadowMapsSizeIsASetting) {
  EXPECT_EQ(untimedComparison({"--set", "shadowMapSize=256"})["settings"]["shadowMapSize"], 256);
}

TEST_F(Command, AnImportanceSaysWhereToRefine) {
  const std::string left = folder_ / "left.png";
  writeImage(left, {{2, 1}, 1, {1.0f, 0.0f}});
  const json either = untimedComparison({"--importance", left, "--set", "refineThreshold=0"});
  const json both =
      untimedComparison({"--importance", left, "--set", "refineThreshold=0", "--set", "combination=1"});
  const json edges = untimedComparison({"--set", "refineThreshold=0"});
  EXPECT_GT(either["coverage"][0], edges["coverage"][0]);
  EXPECT_LT(both["coverage"][0], edges["coverage"][0]);
  EXPECT_EQ(either["settings"]["importance"], left);
}

TEST_F(Command, ShadersOfAFolderWin) {
  writeFile(folder_.path() / "shaders/effects/ssao.glsl",
            "vec4 shade(Surface surface) { return vec4(1.0); }\n");
  EXPECT_EQ(untimedComparison({"--shaders", folder_ / "shaders"})["error"]["rms"], 0.0);
}

/// A scene of which something has to be left out.
TEST_F(Command, WhatASceneLosesIsToldAndReported) {
  json scene = json::parse(readFile(scene_));
  scene["extensionsUsed"] = {"KHR_made_up"};
  writeFile(folder_.path() / "odd.gltf", scene.dump());
  for (const std::string command : {"compare", "render"}) {
    const ProcessResult result = runMres(
        {command, folder_ / "odd.gltf", "--size", "8x8", "--no-timing", "--json", "-o", folder_ / "out.png"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.err, AllOf(testing::StartsWith("mres: note: "), HasSubstr("KHR_made_up")));
    EXPECT_THAT(json::parse(result.out)["results"][0]["warnings"].dump(), HasSubstr("KHR_made_up"));
    fs::remove_all(folder_.path() / "out.png");
  }
}

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
  EXPECT_TRUE(
      fs::exists(folder_.path() / "bench" / report["results"][0]["pictures"]["mres"].get<std::string>()));
  const std::string page = readFile(folder_.path() / "bench/report.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("data:image/jpeg"), HasSubstr("Against the truth"), HasSubstr("</html>")));
  if (first.err.empty()) {  // else it says that there is no gnuplot
    EXPECT_THAT(filesBelow("bench/plots"), testing::Contains("speedup-by-size.svg"));
  }

  EXPECT_EQ(runMres(arguments).out, first.out);
  EXPECT_EQ(readFile(folder_.path() / "bench/results.json"), file) << "something was measured again";
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

/// Waits for a file or folder that a running command makes.
bool appears(const fs::path& path) {
  constexpr int kMostTries = 3000;
  for (int i = 0; i < kMostTries && !fs::exists(path); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return fs::exists(path);
}

TEST_F(Command, AnInterruptLeavesNothingHalfWritten) {
  const fs::path output = folder_.path() / "out";
  RunningMres run({"compare", "hall", "--size", "720p", "--repeat", "10000", "-o", output.string()}, {});
  ASSERT_TRUE(appears(output));
  run.interrupt();
  const ProcessResult result = run.wait();
  EXPECT_EQ(result.exitCode, 128 + SIGINT) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_FALSE(fs::exists(output));
}

TEST_F(Command, AnInterruptKeepsTheCamerasThatAreDone) {
  const fs::path output = folder_.path() / "out";
  RunningMres run(
      {"compare", "office", "--camera", "all", "--size", "720p", "--no-timing", "-o", output.string()}, {});
  ASSERT_TRUE(appears(output / "camera-1"));
  run.interrupt();
  EXPECT_EQ(run.wait().exitCode, 128 + SIGINT);
  const json results = json::parse(readFile(output / "report.json"))["results"];
  ASSERT_GE(results.size(), 1U);
  EXPECT_LT(results.size(), 8U);
  for (const json& result : results)
    EXPECT_TRUE(fs::exists(output / result["pictures"]["levels"].get<std::string>()));
  for (const std::string& file : filesBelow("out")) EXPECT_THAT(file, testing::Not(HasSubstr(".partial")));
}

TEST_F(Command, AnInterruptedBenchGoesOn) {
  const fs::path output = folder_.path() / "bench";
  const auto arguments = [&](const std::string& pairs) {
    return std::vector<std::string>{"bench", "--suite",       "smoke",    "--scenes", scene_,
                                    "-o",    output.string(), "--repeat", pairs};
  };
  RunningMres run(arguments("300"), {});
  ASSERT_TRUE(appears(output / "results.json"));
  run.interrupt();
  const ProcessResult interrupted = run.wait();
  EXPECT_EQ(interrupted.exitCode, 128 + SIGINT) << interrupted.err;
  EXPECT_THAT(interrupted.err, HasSubstr("--resume goes on"));
  EXPECT_FALSE(fs::exists(output / "report.html"));
  const json kept = json::parse(readFile(output / "results.json"))["results"];
  ASSERT_GE(kept.size(), 1U);
  ASSERT_LT(kept.size(), 4U);

  std::vector<std::string> resumed = arguments("2");
  resumed.emplace_back("--resume");
  ASSERT_EQ(runMres(resumed).exitCode, 0);
  const json results = json::parse(readFile(output / "results.json"))["results"];
  ASSERT_EQ(results.size(), 4U);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(results[i], kept[i]) << "was measured again";
}

}  // namespace
}  // namespace host::test
