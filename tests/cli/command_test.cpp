#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

TEST_F(Command, HelpListsEverySettingWithItsRange) {
  EXPECT_THAT(succeed({"compare", "--help"}), AllOf(HasSubstr("Examples"), HasSubstr("radius="),
                                                    HasSubstr("normalThreshold"), HasSubstr("degrees")));
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
  EXPECT_EQ(info["effects"], json({"ssao"}));
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
  EXPECT_EQ(result["time_ms"]["runs"], 3);
  EXPECT_TRUE(result["speedup"].is_null());
  EXPECT_FALSE(result["stages_ms"].empty());
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
  EXPECT_EQ(result["coverage"].back(), 1.0);
  EXPECT_TRUE(result["stages_ms"].contains("composite"));
  EXPECT_TRUE(result["skipped"].is_array());
  EXPECT_GT(result["gpu_bytes"], 0);
  EXPECT_EQ(result["settings"]["samples"], 8);
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

TEST_F(Command, AnInterruptLeavesNothingHalfWritten) {
  const std::string output = folder_ / "out";
  const std::string command = "timeout --signal=INT 3 " MRES_EXECUTABLE
                              " compare hall --size 720p --repeat 10000 -o '" +
                              output + "' 2> /dev/null";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_FALSE(fs::exists(output));
}

}  // namespace
}  // namespace host::test
