// Equation 1, from the coarsest level up, against double precision.
#include <algorithm>
#include <cmath>

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
    "return vec4(0.5 + 0.4 * sin(surface.pixel.x * 0.05 + float(levelStride)) * cos(surface.pixel.y * "
    "0.07));";

/// Bilinear sampling at a place in texels (centres at + 0.5), clamped to the edge.
double bilinear(const Image& image, glm::dvec2 place) {
  const glm::dvec2 corner = glm::floor(place - 0.5);
  const glm::dvec2 weight = place - 0.5 - corner;
  const auto at = [&](int x, int y) {
    const glm::ivec2 texel = glm::clamp(glm::ivec2(corner) + glm::ivec2(x, y), glm::ivec2(0), image.size - 1);
    return static_cast<double>(image.at(texel));
  };
  return (at(0, 0) * (1.0 - weight.x) + at(1, 0) * weight.x) * (1.0 - weight.y) +
         (at(0, 1) * (1.0 - weight.x) + at(1, 1) * weight.x) * weight.y;
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

/// What a level's picture must be, given the picture of the coarser one (empty for the coarsest).
Image compose(const PlannedLevel& level, glm::ivec2 fullSize, const Image& mask, const Image& coarser,
              int coarserLevel) {
  Image picture{level.size, 1, {}};
  for (int y = 0; y < level.size.y; ++y) {
    for (int x = 0; x < level.size.x; ++x) {
      const glm::ivec2 pixel = representative({x, y}, level.index, fullSize);
      double value = valueAt(pixel, level.index);
      if (!coarser.texels.empty()) {
        const double below = bilinear(coarser, placeIn(coarser, pixel, coarserLevel, fullSize));
        const double a = bilinear(mask, (glm::dvec2(pixel) + 0.5) / std::exp2(level.index + 1));
        const double alpha = std::min(a * static_cast<double>(level.settings.blendWeight), 1.0);
        value = value * alpha + below * (1.0 - alpha);
      }
      picture.texels.push_back(static_cast<float>(value));
    }
  }
  return picture;
}

Image composeAll(const LevelPlan& plan, const std::vector<Image>& masks) {
  Image picture;
  int coarserLevel = 0;
  for (std::size_t i = plan.levels.size(); i-- > 0;) {
    const Image mask = i < masks.size() ? masks[i] : Image{};
    picture = compose(plan.levels[i], plan.levels.front().size, mask, picture, coarserLevel);
    coarserLevel = plan.levels[i].index;
  }
  return picture;
}

class Composite : public GlTest {
 protected:
  void expectEquationOne(const SyntheticGBuffer& gbuffer, LevelTable levels, float weight) {
    for (LevelSettings& level : levels) level.blendWeight = weight;
    TestEffect effect({.body = kValue, .levels = levels});
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

TEST_F(Composite, WithoutEdgesIsTheCoarsestLevelUpsampled) {
  const glm::ivec2 size(129, 95);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.4, 0.3, 1.0}, -5.0));
  for (const unsigned levels : {15u, 9u, 3u}) expectEquationOne(gbuffer, levelSubset(levels), 100.0f);
}

}  // namespace
}  // namespace mres::test
