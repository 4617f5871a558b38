// The techniques and the ways to choose levels that are there for comparison: what the command line says
// reaches the picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "tests/cli/command_support.h"

namespace host::test {
namespace {

using nlohmann::json;

class LevelChoice : public Command {
 protected:
  /// At a size that has whole pixels, and whole blocks of them, of all four levels. Coarse levels spare the
  /// finest one something, and the picture is near to the full resolution's.
  json comparison(const std::vector<std::string>& options) {
    json result = comparisonBy(options);
    const json& coverage = result["coverage"];
    EXPECT_EQ(coverage.size(), 4U);
    EXPECT_GT(coverage.front(), 0.0);
    EXPECT_LT(coverage.front(), 1.0);
    EXPECT_LT(result["error"]["rms"], 0.05);
    return result;
  }

  json comparisonBy(const std::vector<std::string>& options) {
    std::vector<std::string> all{"--size", "160x96"};
    all.insert(all.end(), options.begin(), options.end());
    return untimedComparison(all);
  }
};

TEST_F(LevelChoice, ByThePapersMasks) {
  const json paper = comparison({"--technique", "mres-paper"});
  EXPECT_EQ(paper["technique"], "mres-paper");
  EXPECT_EQ(paper["coverage"].back(), 1.0) << "the coarsest level renders the whole screen";
  EXPECT_NE(paper["coverage"], comparisonBy({"--technique", "mres"})["coverage"]);
}

TEST_F(LevelChoice, ByMinMaxMips) {
  const json mips = comparison({"--set", "minMaxMips=1", "--set", "errorBudget=0"});
  const json derivatives = comparison({"--set", "minMaxMips=0", "--set", "errorBudget=0"});
  EXPECT_EQ(mips["settings"]["minMaxMips"], true);
  EXPECT_EQ(derivatives["settings"]["minMaxMips"], false);
  EXPECT_EQ(mips["coverage"].back(), 1.0) << "the coarsest level renders the whole screen";
  EXPECT_GT(mips["coverage"][0], derivatives["coverage"][0]) << "a floor at a grazing angle is all edges";

  const json named = comparison({"--technique", "mres-min-max", "--set", "errorBudget=0"});
  EXPECT_EQ(named["technique"], "mres-min-max");
  EXPECT_EQ(named["coverage"], mips["coverage"]);
}

TEST_F(LevelChoice, OfDisjointLevelsAddsUpToOneScreen) {
  const json disjoint = comparison({"--set", "disjoint=1"});
  EXPECT_EQ(disjoint["settings"]["disjoint"], true);
  // A share of a level's pixels is the same share of the screen.
  const auto shares = disjoint["coverage"].get<std::vector<double>>();
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-9);
}

TEST_F(LevelChoice, IsNotForPeers) {
  const json half = comparisonBy({"--technique", "half-joint"});
  EXPECT_EQ(half["technique"], "half-joint");
  EXPECT_EQ(half["work"], 0.25);
  EXPECT_TRUE(half["coverage"].empty());
  EXPECT_GT(half["error"]["rms"], 0.0);
  EXPECT_LT(half["error"]["rms"], 0.05);
  EXPECT_THAT(filesBelow("out"),
              testing::ElementsAre("difference.png", "effect_full.exr", "effect_full.png", "effect_mres.exr",
                                   "effect_mres.png", "full.png", "mres.png", "report.json"));
}

}  // namespace
}  // namespace host::test
