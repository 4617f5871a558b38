// Options and settings do what they say.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/image/image_file.h"
#include "tests/cli/command_support.h"
#include "tests/cli/process.h"

namespace host::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

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

TEST_F(Command, TheSeedChoosesThePoints) {
  const json first = untimedComparison({"--seed", "1"});
  const json second = untimedComparison({"--seed", "2"});
  EXPECT_EQ(first["settings"]["seed"], 1);
  EXPECT_EQ(second["settings"]["seed"], 2);
  EXPECT_NE(first["error"]["rms"], second["error"]["rms"]);
}

/// The corner, and a small one half a metre above its floor, which casts a shadow on that.
std::string writeSceneWithAShadow(const TemporaryFolder& folder) {
  json scene = json::parse(readFile(writeCornerScene(folder)));
  json& nodes = scene["nodes"];
  scene["scenes"][0]["nodes"].push_back(nodes.size());
  nodes.push_back({{"mesh", 0}, {"scale", {0.25, 0.25, 0.25}}, {"translation", {0.0, 0.5, 0.0}}});
  std::string path = folder / "shadow.gltf";
  writeFile(path, scene.dump());
  return path;
}

TEST_F(Command, TheShadowMapsSizeShowsInTheShadows) {
  scene_ = writeSceneWithAShadow(folder_);
  const auto shadowsWith = [&](int size) {
    const json result = untimedComparison(
        {"--effect", "ssm", "--size", "160x90", "--set", "shadowMapSize=" + std::to_string(size)});
    EXPECT_EQ(result["settings"]["shadowMapSize"], size);
    return readImage(folder_ / "out/effect_full.exr").pixels;
  };
  const std::vector<float> fine = shadowsWith(2048);
  EXPECT_LT(std::ranges::min(fine), 0.1f) << "there is no shadow";
  EXPECT_NE(shadowsWith(64), fine);
}

TEST_F(Command, AnImportanceSaysWhereToRefine) {
  const std::string left = folder_ / "left.png";
  writeImage(left, {{2, 1}, 1, {1.0f, 0.0f}});
  const json either = untimedComparison({"--importance", left, "--set", "errorBudget=0"});
  const json both =
      untimedComparison({"--importance", left, "--set", "errorBudget=0", "--set", "combination=1"});
  const json edges = untimedComparison({"--set", "errorBudget=0"});
  EXPECT_GT(either["coverage"][0], edges["coverage"][0]);
  EXPECT_LT(both["coverage"][0], edges["coverage"][0]);
  EXPECT_EQ(either["settings"]["importance"], left);
}

TEST_F(Command, ShadersOfAFolderWin) {
  writeFile(folder_.path() / "shaders/effects/ssao.glsl",
            "vec4 shade(Surface surface) { return vec4(1.0); }\n");
  EXPECT_EQ(untimedComparison({"--shaders", folder_ / "shaders"})["error"]["rms"], 0.0);
}

}  // namespace
}  // namespace host::test
