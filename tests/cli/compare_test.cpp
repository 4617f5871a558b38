// `mres compare`: its report, its pictures, and its errors against full resolution and truth.
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "host/image/image_file.h"
#include "tests/cli/command_support.h"
#include "tests/cli/process.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

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

TEST_F(Command, CompareMeasuresFlickerWhereAsked) {
  EXPECT_TRUE(untimedComparison({}).at("temporal").is_null());
  const json temporal = untimedComparison({"--frames", "3"}).at("temporal");
  EXPECT_EQ(temporal.at("frames"), 3);
  EXPECT_GT(temporal.at("rms"), 0.0);
  EXPECT_LT(temporal.at("rms"), 0.1);
  EXPECT_LE(temporal.at("rms"), temporal.at("max"));
  EXPECT_GT(temporal.at("reference_change_rms"), 0.0);
  EXPECT_EQ(temporal.at("non_finite"), 0);
}

TEST_F(Command, FlickerIsTheSameWithTimingAndWithoutIt) {
  const json untimed = untimedComparison({"--frames", "2"});
  const json timed = json::parse(
      succeed({"compare", scene_, "--size", "64x36", "--samples", "8", "--repeat", "1", "--set",
               "fallBack=false", "--frames", "2", "--json", "-o", folder_ / "timed"}))["results"][0];
  EXPECT_EQ(timed["temporal"], untimed["temporal"]);
  EXPECT_EQ(timed["error"], untimed["error"]);
}

TEST_F(Command, CompareSaysHowMuchItFlickers) {
  EXPECT_THAT(succeed({"compare", scene_, "--camera", "all", "--size", "64x36", "--no-timing", "--frames",
                       "2", "-o", folder_ / "out"}),
              AllOf(HasSubstr("Flicker"), HasSubstr("corner 0 ssao"), HasSubstr("corner 1 ssao")));
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

TEST_F(Command, WithoutTimingNoStageIsTimed) {
  const json result = untimedComparison({});
  EXPECT_TRUE(result["stages_ms"].empty());
  EXPECT_TRUE(result["stages_clock"].is_null());
  EXPECT_EQ(result["coverage"].back(), 1.0);
  EXPECT_LT(result["coverage"].front(), 1.0);
  EXPECT_GT(result["gpu_bytes"], 0);
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

}  // namespace
}  // namespace host::test
