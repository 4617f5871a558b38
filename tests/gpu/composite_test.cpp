// Equation 1, from the coarsest level up, against double precision.
#include <algorithm>
#include <cmath>

#include "tests/support/gl_test.h"
#include "tests/support/level_reference.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

/// Equation 1, from the coarsest level up.
Image composeAll(const LevelPlan& plan, const std::vector<Image>& masks) {
  const glm::ivec2 fullSize = plan.levels.front().size;
  Image picture = coarsestPicture(plan.levels.back(), fullSize);
  for (std::size_t i = plan.levels.size() - 1; i-- > 0;) {
    const PlannedLevel& level = plan.levels[i];
    Image finer{level.size, 1, {}};
    for (int t = 0; t < level.size.x * level.size.y; ++t) {
      const glm::ivec2 pixel = representative({t % level.size.x, t / level.size.x}, level.index, fullSize);
      const double below = interpolated(picture, pixel, plan.levels[i + 1].index, fullSize);
      const double a = bilinear(masks[i], (glm::dvec2(pixel) + 0.5) / std::exp2(level.index + 1));
      const double alpha = std::min(a * static_cast<double>(level.settings.blendWeight), 1.0);
      finer.texels.push_back(static_cast<float>(below + (valueAt(pixel, level.index) - below) * alpha));
    }
    picture = finer;
  }
  return picture;
}

class Composite : public GlTest {
 protected:
  void expectEquationOne(const SyntheticGBuffer& gbuffer, LevelTable levels, float weight) {
    for (LevelSettings& level : levels) level.blendWeight = weight;
    TestEffect effect(valueIn(levels));
    MultiResolution multiResolution;
    refineByMasks(multiResolution);
    const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
    static_cast<void>(bench_.edges(gbuffer.frame()));
    const LevelPlan plan = planLevels(Technique::multiResolution, levels, gbuffer.frame().size);
    const Image expected = composeAll(plan, bench_.masks(plan));
    // Masks are sampled with eight bits; weights magnify that.
    EXPECT_LT(maxDifference(picture, expected.texels), 0.004 + 0.006 * static_cast<double>(weight));
    EXPECT_LT(rootMeanSquare(picture, expected.texels), 0.002);
  }

  MaskBench bench_;
};

TEST_F(Composite, FollowsEquationOneForEverySubsetOfLevels) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (unsigned levels = 1; levels < 16; levels += 2) {
    SCOPED_TRACE(levels);
    expectEquationOne(gbuffer, levelSubset(levels), 1.0f);
  }
}

TEST_F(Composite, FollowsEquationOneAtOddSizesAndOtherWeights) {
  for (const glm::ivec2 size : {glm::ivec2(64, 64), glm::ivec2(67, 59), glm::ivec2(127, 61)}) {
    SCOPED_TRACE(size.x);
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (const float weight : {1.0f, 2.5f}) expectEquationOne(gbuffer, levelSubset(15), weight);
  }
}

LevelPlan withWeightsTimes(float factor, const LevelPlan& plan) {
  LevelPlan changed;
  for (PlannedLevel level : plan.levels) {
    level.settings.blendWeight *= factor;
    changed.levels.push_back(level);
  }
  return changed;
}

TEST_F(Composite, FollowsEquationOneWithTheWeightsAndVariancesOfTable1) {
  for (const glm::ivec2 size : {glm::ivec2(131, 97), glm::ivec2(256, 192)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    TestEffect effect(valueIn(kSsaoLevels));
    MultiResolution multiResolution;
    refineByMasks(multiResolution);
    const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
    static_cast<void>(bench_.edges(gbuffer.frame()));
    const LevelPlan plan = planLevels(Technique::multiResolution, kSsaoLevels, size);
    const std::vector<Image> masks = bench_.masks(plan);
    // llvmpipe filters eight bits to eight bits, which a weight of 100 makes steps of 0.4.
    constexpr double kLimit = 0.015;
    EXPECT_LT(rootMeanSquare(picture, composeAll(plan, masks).texels), kLimit);
    for (const float factor : {0.5f, 2.0f}) {
      const Image wrong = composeAll(withWeightsTimes(factor, plan), masks);
      EXPECT_GT(rootMeanSquare(picture, wrong.texels), 2.0 * kLimit) << "the test can tell";
    }
  }
}

TEST_F(Composite, WithoutEdgesIsTheCoarsestLevelUpsampled) {
  const glm::ivec2 size(129, 95);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.4, 0.3, 1.0}, -5.0));
  for (const unsigned levels : {15u, 9u, 3u}) expectEquationOne(gbuffer, levelSubset(levels), 100.0f);
}

}  // namespace
}  // namespace mres::test
