#include "mres/plan/level_plan.h"

#include <cmath>
#include <gmock/gmock.h>

#include "effects/ssao/ssao.h"

namespace mres {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::Field;

LevelTable tableOf(unsigned mask) {
  LevelTable table = kSsaoLevels;
  for (std::size_t i = 0; i < table.size(); ++i) table.at(i).used = ((mask >> i) & 1u) != 0;
  return table;
}

std::vector<int> indicesOf(const LevelPlan& plan) {
  std::vector<int> indices;
  for (const PlannedLevel& level : plan.levels) indices.push_back(level.index);
  return indices;
}

TEST(LevelPlan, LevelSizesAreRoundedUp) {
  for (int size = 1; size < 300; ++size) {
    for (int level = 0; level < kMaxLevels; ++level) {
      const auto expected = static_cast<int>(std::ceil(size / std::exp2(level)));
      ASSERT_EQ(levelSize({size, 7}, level).x, expected) << size << " at level " << level;
    }
  }
  EXPECT_EQ(levelSize({16384, 1}, 3), glm::ivec2(2048, 1));
}

TEST(LevelPlan, LargeScreensUseEveryLevelOfTheTableFinestFirst) {
  const LevelPlan plan = planLevels(Technique::multiResolution, kSsaoLevels, {1921, 1080});
  ASSERT_THAT(indicesOf(plan), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(plan.levels[3].size, glm::ivec2(241, 135));
  for (std::size_t i = 0; i < plan.levels.size(); ++i) {
    EXPECT_EQ(plan.levels[i].settings.maskVariance, kSsaoLevels.at(i).maskVariance);
    EXPECT_EQ(plan.levels[i].settings.blendWeight, kSsaoLevels.at(i).blendWeight);
  }
  EXPECT_TRUE(plan.skipped.empty());
}

TEST(LevelPlan, TheTableOfTheIssueIsTheDefault) {
  constexpr std::array<float, kMaxLevels> kVariances = {0.924f, 1.848f, 3.696f, 0.0f};
  constexpr std::array<float, kMaxLevels> kWeights = {100.0f, 50.0f, 20.0f, 1.0f};
  for (std::size_t i = 0; i < kSsaoLevels.size(); ++i) {
    EXPECT_TRUE(kSsaoLevels.at(i).used);
    EXPECT_EQ(kSsaoLevels.at(i).maskVariance, kVariances.at(i));
    EXPECT_EQ(kSsaoLevels.at(i).blendWeight, kWeights.at(i));
    EXPECT_EQ(kSsaoLevels.at(i).noisePeriod, i == 0 ? 4 : 2) << "the full level's is the reference's";
  }
}

TEST(LevelPlan, FullTechniqueIsLevelZeroAloneWhateverTheTable) {
  for (unsigned mask = 0; mask < 16; ++mask) {
    for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(640, 480), glm::ivec2(16384)}) {
      const LevelPlan plan = planLevels(Technique::full, tableOf(mask), size);
      ASSERT_THAT(indicesOf(plan), ElementsAre(0)) << mask;
      EXPECT_EQ(plan.levels.front().size, size);
    }
  }
}

TEST(LevelPlan, TheResultAlwaysHasTheSizeOfTheScreen) {
  for (unsigned mask = 0; mask < 16; ++mask) {
    for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(9, 2000), glm::ivec2(17), glm::ivec2(640, 480)}) {
      const LevelPlan plan = planLevels(Technique::multiResolution, tableOf(mask), size);
      ASSERT_FALSE(plan.levels.empty()) << "levels " << mask << ", size " << size.x;
      EXPECT_EQ(plan.levels.front().size, size) << "levels " << mask;
    }
  }
}

TEST(LevelPlan, EveryLevelIsEitherPlannedOrSkippedWithAReason) {
  for (const glm::ivec2 size :
       {glm::ivec2(1, 4096), glm::ivec2(31, 17), glm::ivec2(64), glm::ivec2(640, 480)}) {
    const LevelPlan plan = planLevels(Technique::multiResolution, tableOf(0b1101), size);
    EXPECT_EQ(plan.levels.size() + plan.skipped.size(), static_cast<std::size_t>(kMaxLevels));
    EXPECT_THAT(plan.skipped, Each(AllOf(Field(&Skip::what, testing::StartsWith("level")),
                                         Field(&Skip::reason, testing::SizeIs(testing::Gt(4u))))));
  }
}

TEST(LevelPlan, TinyScreensHaveLevelZeroAlone) {
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(1, 4096), glm::ivec2(4096, 1), glm::ivec2(7, 5)}) {
    EXPECT_THAT(indicesOf(planLevels(Technique::multiResolution, kSsaoLevels, size)), ElementsAre(0));
  }
}

TEST(LevelPlan, LevelsMayBeLeftOutInTheMiddle) {
  const LevelPlan plan = planLevels(Technique::multiResolution, tableOf(0b1101), {640, 480});
  EXPECT_THAT(indicesOf(plan), ElementsAre(0, 2, 3));
  EXPECT_THAT(plan.skipped, ElementsAre(Field(&Skip::what, "level1")));
}

}  // namespace
}  // namespace mres
