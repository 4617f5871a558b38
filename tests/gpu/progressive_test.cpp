// Where levels render by edges and by what coarser levels showed, and how they are blended, against double
// precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "tests/support/gl_test.h"
#include "tests/support/level_reference.h"
#include "tests/support/mask_bench.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {
namespace {

using Difference = std::function<double(double, double)>;

double plainDifference(double a, double b) {
  return std::abs(a - b);
}

/// What makes a finer level render.
struct Rule {
  double threshold = 0.0;
  Difference difference = plainDifference;
  bool byEdges = true;
  bool byBends = true;
  bool byDifference = true;
};

/// A level's picture, and where it differed from the coarser one (empty where it is the coarsest).
struct Level {
  int index = 0;
  Image picture;
  Image differs;
};

bool bendsAt(const Image& picture, glm::ivec2 texel, const Rule& rule) {
  const auto at = [&](int x, int y) { return static_cast<double>(picture.at(texel + glm::ivec2(x, y))); };
  const double alongX = rule.difference(at(0, 0), 0.5 * (at(-1, 0) + at(1, 0)));
  const double alongY = rule.difference(at(0, 0), 0.5 * (at(0, -1) + at(0, 1)));
  return std::max(alongX, alongY) > 0.5 * rule.threshold;
}

/// The texels that a rectangle, in texels, is interpolated from, at least `border` inside of the picture.
std::vector<glm::ivec2> texelsUnder(const Image& picture, glm::dvec2 low, glm::dvec2 high, int border) {
  const glm::ivec2 end = picture.size - 1 - border;
  const glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor(low - 0.5)), glm::ivec2(border), end);
  const glm::ivec2 last = glm::clamp(glm::ivec2(glm::floor(high - 0.5)) + 1, glm::ivec2(border), end);
  std::vector<glm::ivec2> texels;
  for (int y = first.y; y <= last.y; ++y) {
    for (int x = first.x; x <= last.x; ++x) texels.emplace_back(x, y);
  }
  return texels;
}

/// Whether the coarsest level bends at a texel that a rectangle, in its texels, is interpolated from.
bool bendsIn(const Image& picture, glm::dvec2 low, glm::dvec2 high, const Rule& rule) {
  return std::ranges::any_of(texelsUnder(picture, low, high, 1),
                             [&](glm::ivec2 texel) { return bendsAt(picture, texel, rule); });
}

/// Whether a coarser level shows more than one value there.
bool variesIn(const Image& picture, glm::dvec2 low, glm::dvec2 high, const Rule& rule) {
  std::vector<double> values;
  for (const glm::ivec2 texel : texelsUnder(picture, low, high, 0)) values.push_back(picture.at(texel));
  const auto [least, most] = std::ranges::minmax(values);
  return rule.difference(least, most) > 0.5 * rule.threshold;
}

bool hasEdge(const Image& edges, glm::ivec2 block, int channel) {
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 texel = glm::min(2 * block + glm::ivec2(i % 2, i / 2), edges.size - 1);
    if (edges.at(texel, channel) > 0.0f) return true;
  }
  return false;
}

bool isZone(const PlannedLevel& level, glm::ivec2 block, const Image& edges, const Level& coarser,
            const Rule& rule) {
  const bool coarserIsCoarsest = coarser.differs.texels.empty();
  const bool finest = level.index == 0 && !coarserIsCoarsest;
  const double texels = std::exp2(level.index - coarser.index);
  const glm::dvec2 low = glm::dvec2(block * 4) * texels;
  const glm::dvec2 high = low + 4.0 * texels;
  if (!finest && rule.byEdges) {
    const bool shows = coarserIsCoarsest || variesIn(coarser.picture, low, high, rule);
    if (hasEdge(edges, block, 1) || (shows && hasEdge(edges, block, 0))) return true;
  }
  if (coarserIsCoarsest) return rule.byBends && bendsIn(coarser.picture, low, high, rule);
  return rule.byDifference && largestIn(coarser.differs, low, high, 2) > 0.0;
}

Image zoneOf(const PlannedLevel& level, const Image& edges, const Level& coarser, const Rule& rule) {
  Image zone{(level.size + 3) / 4, 1, {}};
  for (int i = 0; i < zone.size.x * zone.size.y; ++i) {
    const glm::ivec2 block(i % zone.size.x, i / zone.size.x);
    zone.texels.push_back(isZone(level, block, edges, coarser, rule) ? 1.0f : 0.0f);
  }
  return zone;
}

Level compose(const PlannedLevel& level, glm::ivec2 fullSize, const Image& edges, const Level& coarser,
              const Rule& rule) {
  Level composed{level.index, {level.size, 1, {}}, {level.size, 1, {}}};
  const Image zone = zoneOf(level, edges, coarser, rule);
  for (int i = 0; i < level.size.x * level.size.y; ++i) {
    const glm::ivec2 levelPixel(i % level.size.x, i / level.size.x);
    const glm::ivec2 pixel = representative(levelPixel, level.index, fullSize);
    const double below = interpolated(coarser.picture, pixel, coarser.index, fullSize);
    const double value = valueAt(pixel, level.index);
    const bool rendered = zone.at(levelPixel / 4) > 0.0f;
    // Half of the value at the zone's border, all of it half a block inside.
    const double alpha = rendered ? bilinear(zone, (glm::dvec2(levelPixel) + 0.5) / 4.0) : 0.0;
    composed.picture.texels.push_back(static_cast<float>(below + (value - below) * alpha));
    const bool differs = rendered && rule.difference(value, below) > rule.threshold;
    composed.differs.texels.push_back(differs ? 1.0f : 0.0f);
  }
  return composed;
}

Picture composeAll(const LevelPlan& plan, const std::vector<Image>& edges, const Rule& rule) {
  const glm::ivec2 fullSize = plan.levels.front().size;
  Level composed{plan.levels.back().index, coarsestPicture(plan.levels.back(), fullSize), {}};
  for (std::size_t i = plan.levels.size() - 1; i-- > 0;)
    composed = compose(plan.levels[i], fullSize, edges[i], composed, rule);
  return composed.picture.texels;
}

double shareAbove(const Picture& a, const Picture& b, double limit) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) > limit ? 1u : 0u;
  return static_cast<double>(count) / static_cast<double>(a.size());
}

/// Levels whose masks are their edges as they are.
LevelTable unblurred(unsigned subset) {
  LevelTable levels = levelSubset(subset);
  for (LevelSettings& level : levels) level.maskVariance = 0.0f;
  return levels;
}

class Progressive : public GlTest {
 protected:
  std::vector<Image> edgesOf(const Frame& frame, const LevelPlan& plan) {
    static_cast<void>(bench_.edges(frame));
    return bench_.edgesWithFolds(plan);
  }

  MaskBench bench_;
};

TEST_F(Progressive, RendersAtEdgesAndWhereCoarserLevelsSayThatItPays) {
  int edged = 0;  // pictures that need the rule
  int bending = 0;
  int differing = 0;
  for (const glm::ivec2 size : {glm::ivec2(259, 193), glm::ivec2(192, 128)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (const unsigned subset : {0b1111u, 0b1011u, 0b1101u, 0b0111u, 0b0011u, 0b1001u}) {
      for (const float threshold : {0.04f, 0.15f, 0.3f}) {
        SCOPED_TRACE(testing::Message() << size.x << " pixels, levels " << subset << ", " << threshold);
        const LevelTable levels = unblurred(subset);
        const LevelPlan plan = planLevels(Technique::multiResolution, levels, size);
        const std::vector<Image> edges = edgesOf(gbuffer.frame(), plan);
        TestEffect effect(valueIn(levels));
        MultiResolution multiResolution;
        multiResolution.settings().mask.errorBudget = threshold / MaskSettings::kDifferencePerError;
        const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
        Rule rule{.threshold = static_cast<double>(threshold)};
        const Picture expected = composeAll(plan, edges, rule);
        // A change within rounding of the threshold may be decided either way.
        EXPECT_LT(rootMeanSquare(picture, expected), 0.004);
        EXPECT_LT(shareAbove(picture, expected, 0.01), 0.003);
        rule.byBends = false;
        bending += shareAbove(composeAll(plan, edges, rule), expected, 0.01) > 0.01 ? 1 : 0;
        rule = {.threshold = rule.threshold, .byDifference = false};
        differing += shareAbove(composeAll(plan, edges, rule), expected, 0.01) > 0.01 ? 1 : 0;
        rule = {.threshold = rule.threshold, .byEdges = false};
        edged += shareAbove(composeAll(plan, edges, rule), expected, 0.01) > 0.01 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(edged, 5) << "the test can tell whether edges have a say";
  EXPECT_GT(bending, 5) << "the test can tell whether the coarsest level has a say";
  EXPECT_GT(differing, 5) << "the test can tell whether others have";
}

TEST_F(Progressive, ComparesRadiancesByTheirContrast) {
  const glm::ivec2 size(384, 256);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LevelTable levels = unblurred(15);
  const LevelPlan plan = planLevels(Technique::multiResolution, levels, size);
  const std::vector<Image> edges = edgesOf(gbuffer.frame(), plan);
  for (const double brightness : {40.0, 1.0, 0.03}) {
    SCOPED_TRACE(brightness);
    // Below a radiance of 0.05 there is less to see.
    const auto contrast = [&](double a, double b) {
      return brightness * std::abs(a - b) / std::max(brightness * (a + b), 0.1);
    };
    TestEffect effect({.body = valueInGlsl() + "return " + std::to_string(brightness) +
                               " * value * vec4(0.25, 1.0, 0.5, 0.0);",
                       .channels = 3,
                       .levels = levels});
    MultiResolution multiResolution;
    multiResolution.settings().mask.errorBudget = 0.15f / MaskSettings::kDifferencePerError;
    const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
    Picture values;
    for (std::size_t i = 1; i < picture.size(); i += 3)
      values.push_back(static_cast<float>(static_cast<double>(picture[i]) / brightness));
    const Picture expected = composeAll(plan, edges, {.threshold = 0.15, .difference = contrast});
    EXPECT_LT(rootMeanSquare(values, expected), 0.004);
    EXPECT_LT(shareAbove(values, expected, 0.01), 0.003);
    EXPECT_GT(shareAbove(composeAll(plan, edges, {.threshold = 0.15}), expected, 0.01), 0.004)
        << "the test can tell";
  }
}

TEST_F(Progressive, ALineOfOnePixelsWidthIsWholeWhereverItLies) {
  const glm::ivec2 size(256, 192);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.0, 0.0, 1.0}, -10.0));
  for (const std::string axis : {"x", "y"}) {
    for (int line = 64; line < 72; ++line) {
      SCOPED_TRACE(axis + " = " + std::to_string(line));
      const std::string value =
          "(int(surface.pixel." + axis + ") == " + std::to_string(line) + " ? 1.0 : 0.0)";
      TestEffect effect({.body = "return vec4(" + value + ");",
                         .filtered = true,
                         .name = "line " + axis + std::to_string(line),
                         .preview = "return vec2(" + value + ");"});
      MultiResolution multiResolution;
      const Picture levels = renderPicture(multiResolution, effect, gbuffer.frame());
      multiResolution.settings().technique = Technique::full;
      const Picture full = renderPicture(multiResolution, effect, gbuffer.frame());
      EXPECT_LT(maxDifference(levels, full), 0.1) << "a line that is lost makes 0.25";
    }
  }
}

/// A wall 5 m away, which turns aside between two columns of the picture.
RayCaster wallWithStrip(glm::ivec2 size, int firstColumn, int width) {
  const auto projection = glm::dmat4(perspective(size));
  const auto metresAt = [=](int column) { return (2.0 * column / size.x - 1.0) * 5.0 / projection[0][0]; };
  return [=, wall = plane({0.0, 0.0, 1.0}, -5.0)](glm::dvec3 origin, glm::dvec3 direction) {
    std::optional<Hit> hit = wall(origin, direction);
    const double x = origin.x + direction.x * 5.0;
    const bool turned = x > metresAt(firstColumn) && x < metresAt(firstColumn + width);
    if (hit && turned) hit->normal = {std::sin(1.0), 0.0, std::cos(1.0)};
    return hit;
  };
}

/// Dark where the wall turns aside.
TestEffect::Recipe darkStrip() {
  return {.body = "return vec4(surface.normal.x > 0.5 ? 0.0 : 1.0);", .levels = unblurred(15)};
}

TEST_F(Progressive, WhatTheQuarterLevelMissedIsRefinedThoughItsPictureIsFlat) {
  const glm::ivec2 size(256, 192);
  MultiResolution multiResolution;
  TestEffect effect(darkStrip());
  for (int column = 64; column < 72; ++column) {
    SCOPED_TRACE(column);
    const SyntheticGBuffer gbuffer(size, perspective(size), wallWithStrip(size, column, 2));
    multiResolution.settings().technique = Technique::multiResolution;
    const Picture levels = renderPicture(multiResolution, effect, gbuffer.frame());
    multiResolution.settings().technique = Technique::full;
    EXPECT_LT(maxDifference(levels, renderPicture(multiResolution, effect, gbuffer.frame())), 0.1)
        << "a strip that is lost makes 1";
  }
}

TEST_F(Progressive, EdgesThatDontShowCostTheHalfLevelNothing) {
  const glm::ivec2 size(256, 192);
  const SyntheticGBuffer gbuffer(size, perspective(size), wallWithStrip(size, 100, 60));
  MultiResolution multiResolution({.measureCoverage = true});
  const auto coverage = [&](TestEffect&& effect) {
    multiResolution.forget("test");
    for (int frame = 0; frame < 2; ++frame) {
      multiResolution.render(effect, gbuffer.frame());
      glFinish();
    }
    const std::vector<LevelReport>& levels = multiResolution.report().levels;
    return std::array{levels.at(1).coverage, levels.at(2).coverage};
  };
  const auto [flatHalf, flatQuarter] = coverage(TestEffect({.body = "return vec4(0.37);"}));
  EXPECT_EQ(flatHalf, 0.0);
  EXPECT_GT(flatQuarter, 0.0) << "the quarter level looks";
  const auto [darkHalf, darkQuarter] = coverage(TestEffect(darkStrip()));
  EXPECT_GT(darkHalf, 0.0);
  EXPECT_EQ(darkQuarter, flatQuarter);
}

TEST_F(Progressive, FoldsTooNarrowForTheCoarsestLevelAreLookedAtWhateverItShows) {
  const glm::ivec2 size(256, 192);
  const SyntheticGBuffer gbuffer(size, perspective(size), curtain(5.0, 1.0, 40.0));
  TestEffect effect({.body = "return vec4(0.37);", .levels = unblurred(15)});
  for (const Technique technique : {Technique::multiResolution, Technique::paper}) {
    MultiResolution multiResolution({.measureCoverage = true});
    multiResolution.settings().technique = technique;
    for (int frame = 0; frame < 2; ++frame) {
      multiResolution.render(effect, gbuffer.frame());
      glFinish();
    }
    const auto& levels = multiResolution.report().levels;
    const bool hasFolds = technique == Technique::multiResolution;
    EXPECT_EQ(levels[0].coverage, 0.0) << "pixel by pixel it is smooth";
    EXPECT_EQ(levels[1].coverage, 0.0) << "the quarter level finds nothing there";
    EXPECT_EQ(levels[2].coverage > 0.5, hasFolds);
  }
}

TEST_F(Progressive, WithAThresholdOfZeroEdgesAloneDecide) {
  const glm::ivec2 size(192, 128);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  MultiResolution multiResolution({.measureCoverage = true});
  multiResolution.settings().mask.errorBudget = 0.0f;
  TestEffect effect({.body = "return vec4(0.37);", .levels = unblurred(15)});
  for (int frame = 0; frame < 2; ++frame) {
    multiResolution.render(effect, gbuffer.frame());
    glFinish();
  }
  for (const LevelReport& level : multiResolution.report().levels)
    EXPECT_GT(level.coverage, 0.0) << "level " << level.index;
}

}  // namespace
}  // namespace mres::test
