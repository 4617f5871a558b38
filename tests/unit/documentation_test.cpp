// What the README says of settings is what the headers say.
#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "host/console/options.h"

namespace host {
namespace {

struct DocumentedDefault {
  std::string name;
  std::string effect;  ///< or another word for settings of no single effect
  double value = 0.0;
};

/// The rows "| `name` | of | default | ..." of the README.
std::vector<DocumentedDefault> documentedDefaults() {
  std::vector<DocumentedDefault> defaults;
  std::ifstream stream(MRES_SOURCE_DIRECTORY "/README.md");
  const std::regex row(R"(\| `(\w+)` \| `?(\w+)`? \| ([^|]*) \|.*)");
  std::smatch cells;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_match(line, cells, row)) defaults.push_back({cells[1], cells[2], std::stod(cells[3])});
  return defaults;
}

TEST(Readme, HasTheDefaultsOfTheHeaders) {
  std::set<std::string> effects;
  for (const auto& [name, effect, value] : documentedDefaults()) {
    PictureSettings settings;
    if (std::ranges::count(effectNames(), effect) > 0) settings.effect = effect;
    effects.insert(effect);
    const Json values = settingsTable(settings).values();
    ASSERT_TRUE(values.contains(name)) << name << " is no setting of " << effect;
    const Json& actual = values[name];
    EXPECT_EQ(value, actual.is_boolean() ? double(actual.get<bool>()) : actual.get<double>()) << name;
  }
  EXPECT_THAT(effects, testing::IsSupersetOf({"masks", "ssao", "ssm", "ssgi"}));
}

TEST(Readme, NamesNoOtherVersion) {
  const std::regex version(R"(mres v?(\d+\.\d+\.\d+))");
  for (const char* file : {"README.md", "docs/architecture.md", "docs/integrate.md", "docs/results.md"}) {
    std::ifstream stream(std::string(MRES_SOURCE_DIRECTORY "/") + file);
    ASSERT_TRUE(stream) << file;
    std::smatch match;
    for (std::string line; std::getline(stream, line);) {
      if (!std::regex_search(line, match, version)) continue;
      EXPECT_EQ(match[1], makeReport({})["version"].get<std::string>()) << file;
    }
  }
}

}  // namespace
}  // namespace host
