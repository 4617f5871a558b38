// What mres tells of itself: its help, its version, and what it finds and offers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/command_support.h"

namespace host::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

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

TEST_F(Command, HelpTellsWhatEachTechniqueIs) {
  const json info = json::parse(succeed({"info", "--json"}));
  const std::string help = succeed({"compare", "--help"});
  for (const json& technique : info["techniques"])
    EXPECT_THAT(help, HasSubstr(technique.get<std::string>() + ": "));
}

TEST_F(Command, SaysItsVersion) {
  EXPECT_EQ(succeed({"--version"}), "mres " MRES_VERSION "\n");
  EXPECT_EQ(json::parse(succeed({"info", "--json"}))["version"], MRES_VERSION);
}

TEST_F(Command, InfoNamesDeviceScenesEffectsAndTechniques) {
  EXPECT_THAT(succeed({"info"}),
              AllOf(HasSubstr("OpenGL"), HasSubstr("office, hall, breakfast"), HasSubstr("ssao"),
                    HasSubstr("full, mres-paper, mres-min-max, mres, half-bilinear")));
}

TEST_F(Command, InfoAsJson) {
  const json info = json::parse(succeed({"info", "--json"}));
  EXPECT_EQ(info["schema"], 1);
  EXPECT_GT(info["machine"]["cores"], 0);
  EXPECT_FALSE(info["machine"]["renderer"].get<std::string>().empty());
  EXPECT_EQ(info["scenes"], json({"office", "hall", "breakfast"}));
  EXPECT_EQ(info["techniques"],
            json({"full", "mres-paper", "mres-min-max", "mres", "half-bilinear", "half-joint",
                  "quarter-bilinear", "quarter-joint", "checkerboard", "interleaved", "adaptive-tiles"}));
  EXPECT_EQ(info["effects"], json({"ssao", "ssm", "ssgi"}));
  EXPECT_GE(info["limits"]["texture_size"], 1024);
}

}  // namespace
}  // namespace host::test
