// What the README says of settings is what the headers say.
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <string>

#include "host/commands/options.h"

namespace host {
namespace {

/// The rows "| `name` | default | ..." of the README.
std::map<std::string, std::string> documentedDefaults() {
  std::map<std::string, std::string> defaults;
  std::ifstream stream(MRES_SOURCE_DIRECTORY "/README.md");
  const std::regex row(R"(\| `(\w+)` \| ([^|]*) \|.*)");
  std::smatch cells;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_match(line, cells, row)) defaults[cells[1]] = cells[2];
  return defaults;
}

TEST(Readme, HasTheDefaultsOfTheHeaders) {
  PictureSettings settings;
  const Json values = settingsTable(settings).values();
  const auto documented = documentedDefaults();
  EXPECT_GE(documented.size(), 5U);
  for (const auto& [name, text] : documented) {
    ASSERT_TRUE(values.contains(name)) << name << " is no setting";
    EXPECT_EQ(std::stod(text), values[name].get<double>()) << name;
  }
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
