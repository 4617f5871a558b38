// Equation 1, from the coarsest level up, against double precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "tests/support/gl_test.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

/// The same in GLSL below: differs between levels and between pixels.
double valueAt(glm::ivec2 fullPixel, int level) {
  const glm::dvec2 pixel = glm::dvec2(fullPixel) + 0.5;
  return 0.5 + 0.4 * std::sin(pixel.x * 0.05 + (1 << level)) * std::cos(pixel.y * 0.07);
}
constexpr const char* kValue =
    "float value = 0.5 + 0.4 * sin(surface.pixel.x * 0.05 + float(levelStride)) * cos(surface.pixel.y * "
    "0.07);";

/// An effect of these values.
TestEffect::Recipe valueIn(const LevelTable& levels) {
  return {.body = std::string(kValue) + "return vec4(value);", .levels = levels};
}

/// Radiances whose largest channel is `brightness` times the value.
TestEffect::Recipe radianceIn(const LevelTable& levels, double brightness) {
  const std::string radiance =
      "return " + std::to_string(brightness) + " * value * vec4(0.25, 1.0, 0.5, 0.0);";
  return {.body = kValue + radiance, .channels = 3, .levels = levels};
}

glm::ivec2 representative(glm::ivec2 pixel, int level, glm::ivec2 fullSize) {
  return glm::min(pixel * (1 << level) + (1 << level) / 2, fullSize - 1);
}

/// Where a pixel of the full resolution lies among the pixels of a coarser level, at which that was
/// evaluated, along one axis: in texels, with centres at + 0.5.
double placeAlong(int pixel, int level, int texels, int fullSize) {
  const auto position = [&](int texel) {
    return representative(glm::ivec2(texel), level, glm::ivec2(fullSize)).x;
  };
  if (pixel < position(0) || texels == 1) return 0.0;  // before the first centre: clamped
  int left = 0;
  while (left + 2 < texels && position(left + 1) <= pixel) ++left;
  return left + 0.5 + static_cast<double>(pixel - position(left)) / (position(left + 1) - position(left));
}

glm::dvec2 placeIn(const Image& coarser, glm::ivec2 pixel, int level, glm::ivec2 fullSize) {
  return {placeAlong(pixel.x, level, coarser.size.x, fullSize.x),
          placeAlong(pixel.y, level, coarser.size.y, fullSize.y)};
}

/// A level's picture, and where it says that refining pays (empty where it has no say).
struct Composed {
  int level = 0;
  Image picture;
  Image refine;
};

/// The weight that is left at the border of a zone that refinement limits: none there, all of it half a block
/// inside.
double zoneWeight(const Image& zone, glm::ivec2 levelPixel) {
  return std::max(1.0 - 2.0 * (1.0 - bilinear(zone, (glm::dvec2(levelPixel) + 0.5) / 4.0)), 0.0);
}

/// Whether a level renders a block of 4x4 pixels: its mask and, where there is one, the coarser
/// level's say are above zero somewhere in it.
bool isZone(const PlannedLevel& level, glm::ivec2 block, const Image& mask, const Composed& coarser) {
  const double stride = std::exp2(level.index);
  const glm::dvec2 low = glm::dvec2(block * 4) * stride;
  const glm::dvec2 high = low + 4.0 * stride;
  if (largestIn(mask, low / (2.0 * stride), high / (2.0 * stride), 2) == 0.0) return false;
  if (coarser.refine.texels.empty()) return true;
  const double coarserStride = std::exp2(coarser.level);
  return largestIn(coarser.refine, low / coarserStride, high / coarserStride, 2) > 0.0;
}

Image zoneOf(const PlannedLevel& level, const Image& mask, const Composed& coarser) {
  Image zone{(level.size + 3) / 4, 1, {}};
  for (int i = 0; i < zone.size.x * zone.size.y; ++i) {
    const glm::ivec2 block(i % zone.size.x, i / zone.size.x);
    zone.texels.push_back(isZone(level, block, mask, coarser) ? 1.0f : 0.0f);
  }
  return zone;
}

/// What makes the full level refine its coarser one. Without a threshold the masks alone do.
struct Refinement {
  double threshold = 0.0;
  std::function<double(double, double)> difference = [](double a, double b) { return std::abs(a - b); };
  bool fades = true;
  bool decides = true;  ///< whether the level has a say
};

/// The weight of equation 1.
double alphaAt(const PlannedLevel& level, glm::ivec2 pixel, const Image& mask) {
  const double a = bilinear(mask, (glm::dvec2(pixel) + 0.5) / std::exp2(level.index + 1));
  return std::min(a * static_cast<double>(level.settings.blendWeight), 1.0);
}

Composed composeCoarsest(const PlannedLevel& level, glm::ivec2 fullSize) {
  Composed composed{level.index, {level.size, 1, {}}, {}};
  for (int i = 0; i < level.size.x * level.size.y; ++i) {
    const glm::ivec2 pixel = representative({i % level.size.x, i / level.size.x}, level.index, fullSize);
    composed.picture.texels.push_back(static_cast<float>(valueAt(pixel, level.index)));
  }
  return composed;
}

/// What a level must be over the coarser one.
Composed compose(const PlannedLevel& level, glm::ivec2 fullSize, const Image& mask, const Composed& coarser,
                 const Refinement& refinement) {
  Composed composed{level.index, {level.size, 1, {}}, {level.size, 1, {}}};
  const Image zone = zoneOf(level, mask, coarser);
  for (int i = 0; i < level.size.x * level.size.y; ++i) {
    const glm::ivec2 levelPixel(i % level.size.x, i / level.size.x);
    const glm::ivec2 pixel = representative(levelPixel, level.index, fullSize);
    const double below = bilinear(coarser.picture, placeIn(coarser.picture, pixel, coarser.level, fullSize));
    const double value = valueAt(pixel, level.index);
    const bool rendered = zone.at(levelPixel / 4) > 0.0f;
    const bool fades = refinement.fades && !coarser.refine.texels.empty();
    const double share = fades ? zoneWeight(zone, levelPixel) : 1.0;
    const double alpha = rendered ? alphaAt(level, pixel, mask) * share : 0.0;
    composed.picture.texels.push_back(static_cast<float>(below + (value - below) * alpha));
    const bool differs = rendered && refinement.difference(value, below) > refinement.threshold;
    composed.refine.texels.push_back(differs ? 1.0f : 0.0f);
  }
  if (!refinement.decides) composed.refine = {};
  return composed;
}

Image composeAll(const LevelPlan& plan, const std::vector<Image>& masks, const Refinement& refinement = {}) {
  const glm::ivec2 fullSize = plan.levels.front().size;
  Composed composed = composeCoarsest(plan.levels.back(), fullSize);
  for (std::size_t i = plan.levels.size() - 1; i-- > 0;) {
    Refinement seen = refinement;
    seen.decides = i == 1 && refinement.threshold > 0.0;
    composed = compose(plan.levels[i], fullSize, masks[i], composed, seen);
  }
  return composed.picture;
}

class Composite : public GlTest {
 protected:
  void expectEquationOne(const SyntheticGBuffer& gbuffer, LevelTable levels, float weight) {
    for (LevelSettings& level : levels) level.blendWeight = weight;
    TestEffect effect(valueIn(levels));
    MultiResolution multiResolution;
    refineAtEveryEdge(multiResolution);
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

double shareAbove(const Picture& a, const Picture& b, double limit) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    count += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) > limit ? 1u : 0u;
  }
  return static_cast<double>(count) / static_cast<double>(a.size());
}

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

TEST_F(Composite, RefinesWhereTheCoarserLevelsSayThatItPays) {
  int fading = 0;  // pictures that show it
  for (const glm::ivec2 size : {glm::ivec2(131, 97), glm::ivec2(192, 128)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (const unsigned subset : {0b1111u, 0b1011u, 0b1101u, 0b0111u, 0b0011u}) {
      for (const float threshold : {0.15f, 0.3f, 0.5f}) {
        SCOPED_TRACE(testing::Message() << size.x << " pixels, levels " << subset << ", " << threshold);
        LevelTable levels = levelSubset(subset);
        for (LevelSettings& level : levels) level.blendWeight = 1.0f;
        TestEffect effect(valueIn(levels));
        MultiResolution multiResolution;
        multiResolution.settings().mask.refineThreshold = threshold;
        const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
        static_cast<void>(bench_.edges(gbuffer.frame()));
        const LevelPlan plan = planLevels(Technique::multiResolution, levels, size);
        const std::vector<Image> masks = bench_.masks(plan);
        const Refinement refinement{.threshold = static_cast<double>(threshold)};
        const Image expected = composeAll(plan, masks, refinement);
        // A change within rounding of the threshold may be decided either way.
        EXPECT_LT(rootMeanSquare(picture, expected.texels), 0.003);
        EXPECT_LT(shareAbove(picture, expected.texels, 0.01), 0.002);
        const bool hasSay = plan.levels.size() > 2;
        EXPECT_EQ(shareAbove(composeAll(plan, masks).texels, expected.texels, 0.01) > 0.004, hasSay)
            << "the test can tell whether levels have a say";
        const Image sharp = composeAll(plan, masks, {.threshold = refinement.threshold, .fades = false});
        fading += shareAbove(sharp.texels, expected.texels, 0.01) > 0.004 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(fading, 5) << "the test can tell whether zones fade";
}

TEST_F(Composite, RefinesRadiancesByTheirContrast) {
  const glm::ivec2 size(192, 128);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  LevelTable levels = levelSubset(15);
  for (LevelSettings& level : levels) level.blendWeight = 1.0f;
  const LevelPlan plan = planLevels(Technique::multiResolution, levels, size);
  static_cast<void>(bench_.edges(gbuffer.frame()));
  const std::vector<Image> masks = bench_.masks(plan);
  for (const double brightness : {40.0, 1.0, 0.03}) {
    SCOPED_TRACE(brightness);
    // Below a radiance of 0.05 there is less to see.
    const auto contrast = [&](double a, double b) {
      return brightness * std::abs(a - b) / std::max(brightness * (a + b), 0.1);
    };
    TestEffect effect(radianceIn(levels, brightness));
    MultiResolution multiResolution;
    multiResolution.settings().mask.refineThreshold = 0.15f;
    const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
    Picture values;
    for (std::size_t i = 1; i < picture.size(); i += 3)
      values.push_back(static_cast<float>(static_cast<double>(picture[i]) / brightness));
    const Image expected = composeAll(plan, masks, {.threshold = 0.15, .difference = contrast});
    EXPECT_LT(rootMeanSquare(values, expected.texels), 0.003);
    EXPECT_LT(shareAbove(values, expected.texels, 0.01), 0.002);
    EXPECT_GT(shareAbove(composeAll(plan, masks, {.threshold = 0.15}).texels, expected.texels, 0.01), 0.004)
        << "the test can tell";
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
    refineAtEveryEdge(multiResolution);
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
