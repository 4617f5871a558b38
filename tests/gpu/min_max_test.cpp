// The decomposition by min/max mips: ranges of blocks, compared with C++, and what follows for zones.
#include <algorithm>
#include <gmock/gmock.h>
#include <limits>

#include "mres/level/frame_params.h"
#include "mres/level/frame_textures.h"
#include "mres/mask/mask_pass.h"
#include "mres/mask/min_max_pass.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"
#include "tests/support/mask_bench.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

struct Range {
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  bool sky = false;
  glm::dvec3 least{2.0};
  glm::dvec3 largest{-2.0};
};

/// Of the pixels from `corner` on, those off the screen left out, from the G-buffer in double precision.
Range rangeOf(const SyntheticGBuffer& gbuffer, glm::ivec2 corner, int pixels) {
  const glm::ivec2 size = gbuffer.frame().size;
  const glm::dmat4 p(gbuffer.frame().projection);
  Range range;
  for (int y = corner.y; y < std::min(corner.y + pixels, size.y); ++y) {
    for (int x = corner.x; x < std::min(corner.x + pixels, size.x); ++x) {
      const auto index = static_cast<std::size_t>(y * size.x + x);
      const double windowDepth = gbuffer.depths()[index];
      if (windowDepth == 1.0) {
        range.sky = true;
        continue;
      }
      const double viewDepth = p[3][2] / (windowDepth * 2.0 - 1.0 + p[2][2]);
      range.nearest = std::min(range.nearest, viewDepth);
      range.farthest = std::max(range.farthest, viewDepth);
      const glm::dvec3 normal(gbuffer.normals()[index]);
      range.least = glm::min(range.least, normal);
      range.largest = glm::max(range.largest, normal);
    }
  }
  return range;
}

constexpr int kUnclear = -1;

/// 1 above the threshold, 0 below it, and unclear where rounding may decide.
int exceeds(double value, double threshold) {
  if (std::abs(value - threshold) < 0.01 * threshold) return kUnclear;
  return value > threshold ? 1 : 0;
}

class MinMax : public GlTest {
 protected:
  MinMax() { context_.library = shaderLibrary(); }

  void draw(const SyntheticGBuffer& gbuffer, const LevelPlan& plan, const MaskSettings& settings = {}) {
    params::FrameParams params = frameParams(gbuffer.frame());
    params.depthRounding = depthRounding(bindFrameTextures(context_, gbuffer.frame()));
    frameBlock_.upload(params);
    frameBlock_.bind(kFrameBlock);
    pass_.draw(context_, settings, params, plan);
  }

  static void expectLikeReference(const Image& edges, const SyntheticGBuffer& gbuffer, int level,
                                  int coarser) {
    const double normalThreshold = 2.0 * std::sin(glm::radians(10.0));
    const int blockTexels = 1 << (coarser - 1 - level);
    const int blockPixels = 1 << coarser;
    for (int i = 0; i < edges.size.x * edges.size.y; ++i) {
      const glm::ivec2 texel(i % edges.size.x, i / edges.size.x);
      const Range range = rangeOf(gbuffer, texel / blockTexels * blockPixels, blockPixels + 1);
      const int normal = exceeds(glm::length(glm::max(range.largest - range.least, 0.0)), normalThreshold);
      int depth = exceeds(std::max(range.farthest - range.nearest, 0.0), 0.05);
      if (range.sky) depth = range.farthest > 0.0 ? 1 : 0;
      if (normal != kUnclear) {
        ASSERT_EQ(edges.at(texel, 0), static_cast<float>(normal))
            << level << ": " << texel.x << ", " << texel.y;
      }
      if (depth != kUnclear) {
        ASSERT_EQ(edges.at(texel, 1), static_cast<float>(depth))
            << level << ": " << texel.x << ", " << texel.y;
      }
    }
  }

  PassContext context_;
  gl::UniformBuffer<params::FrameParams> frameBlock_;
  MinMaxPass pass_{shaderLibrary()};
};

LevelPlan planOf(glm::ivec2 size, unsigned levels) {
  return planLevels(Technique::multiResolution, levelSubset(levels), size);
}

TEST_F(MinMax, EdgesAreWhereARangeOfABlockExceedsItsThreshold) {
  const RayCaster withSky =
      nearest({sphere({0.4, 0.1, -4.0}, 1.5), box({-3.0, -2.0, -7.0}, {-1.0, 1.0, -5.0})});
  for (const RayCaster& scene : {room(), withSky}) {
    for (const glm::ivec2 size : {glm::ivec2(128, 96), glm::ivec2(97, 61)}) {
      const SyntheticGBuffer gbuffer(size, perspective(size), scene);
      for (const unsigned levels : {0b1111u, 0b1101u, 0b1011u, 0b1001u}) {
        const LevelPlan plan = planOf(size, levels);
        draw(gbuffer, plan);
        for (std::size_t i = 0; i + 1 < plan.levels.size(); ++i) {
          const int level = plan.levels[i].index;
          const Image edges = readImage(pass_.edges(level), 2);
          ASSERT_EQ(edges.size, levelSize(size, level + 1));
          expectLikeReference(edges, gbuffer, level, plan.levels[i + 1].index);
        }
      }
    }
  }
}

TEST_F(MinMax, EveryPositionOfAStepIsFoundAtEveryLevel) {
  const glm::ivec2 size(72, 64);
  const LevelPlan plan = planOf(size, 0b1111);
  for (int border = 1; border < 20; ++border) {
    const auto scene = [&](glm::dvec3 origin, glm::dvec3 direction) {
      const double x = (direction.x * static_cast<double>(perspective(size)[0][0]) + 1.0) * 0.5 * size.x;
      return plane({0.0, 0.0, 1.0}, x < border ? -3.0 : -4.0)(origin, direction);
    };
    draw(SyntheticGBuffer(size, perspective(size), scene), plan);
    for (int level = 0; level < 3; ++level) {
      const Image edges = readImage(pass_.edges(level), 2);
      for (int y = 0; y < edges.size.y; ++y) {
        int found = 0;
        for (int x = 0; x < edges.size.x; ++x) found += edges.at({x, y}, 1) > 0.0f ? 1 : 0;
        ASSERT_GE(found, 1) << "border " << border << ", level " << level;
        ASSERT_LE(found, 2) << "border " << border << ", level " << level;
      }
    }
  }
}

/// Texels of an edge image above zero.
int count(const Image& edges) {
  return static_cast<int>(std::ranges::count_if(edges.texels, [](float texel) { return texel > 0.0f; }));
}

TEST_F(MinMax, APlaneThatFacesTheCameraHasNoneAndAGrazingOneIsSplitFromTheCoarsestLevelOn) {
  const glm::ivec2 size(128, 96);
  const LevelPlan plan = planOf(size, 0b1111);
  draw(SyntheticGBuffer(size, perspective(size), plane({0.0, 0.0, 1.0}, -6.0)), plan);
  for (int level = 0; level < 3; ++level) EXPECT_EQ(count(readImage(pass_.edges(level), 2)), 0) << level;
  draw(SyntheticGBuffer(size, perspective(size), plane({0.0, 0.3, 1.0}, -3.0)), plan);
  EXPECT_EQ(count(readImage(pass_.edges(0), 2)), 0);
  EXPECT_EQ(count(readImage(pass_.edges(2), 2)), 16 * 12) << "the known weakness";
}

TEST_F(MinMax, MasksContainThoseOfFinerLevels) {
  MaskPass masks(context_.library);
  const glm::ivec2 size(195, 131);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const float variance : {0.0f, 2.0f}) {
    for (const unsigned levels : {0b1111u, 0b1101u, 0b1011u}) {
      LevelTable table = levelSubset(levels);
      for (LevelSettings& level : table) level.maskVariance = variance;
      const LevelPlan plan = planLevels(Technique::multiResolution, table, size);
      draw(gbuffer, plan);
      MaskSources sources{.edges = &pass_.edges(0)};
      for (int level : {1, 2}) {
        if (table.at(static_cast<std::size_t>(level)).used) {
          sources.joined.at(static_cast<std::size_t>(level)) = &pass_.edges(level);
        }
      }
      masks.drawEdges(context_, sources, plan);
      masks.drawBlurred(context_, plan);
      for (std::size_t i = 0; i + 2 < plan.levels.size(); ++i) {
        const int ratio = 1 << (plan.levels[i + 1].index - plan.levels[i].index);
        const Image finer = readImage(masks.blurred(plan.levels[i].index), 1);
        const Image coarser = readImage(masks.blurred(plan.levels[i + 1].index), 1);
        ASSERT_GT(count(coarser), 0);
        for (int t = 0; t < finer.size.x * finer.size.y; ++t) {
          const glm::ivec2 texel(t % finer.size.x, t / finer.size.x);
          ASSERT_LE(finer.at(texel) > 0.0f, coarser.at(texel / ratio) > 0.0f) << texel.x << ", " << texel.y;
        }
      }
    }
  }
}

class MinMaxPictures : public GlTest {
 protected:
  MinMaxPictures() {
    refineByMasks(multiResolution_);
    multiResolution_.settings().mask.minMaxMips = true;
  }
  Picture picture(Effect& effect, const RayCaster& scene, const gl::Texture2D* importance = nullptr) {
    const SyntheticGBuffer gbuffer(size_, perspective(size_), scene);
    Frame frame = gbuffer.frame();
    if (importance != nullptr) frame.importance = importance->id();
    return renderPicture(multiResolution_, effect, frame);
  }

  const glm::ivec2 size_{192, 128};
  MultiResolution multiResolution_;
};

constexpr float kCoarsest = 0.75f;

TEST_F(MinMaxPictures, SplitAGrazingPlaneWhereTheEdgeDetectorDoesNot) {
  TestEffect effect(levelNumbers());
  const RayCaster floor = plane({0.0, 1.0, 0.1}, -1.0);
  multiResolution_.settings().mask.minMaxMips = false;
  const auto coarsest = [](const Picture& picture) { return std::ranges::count(picture, kCoarsest); };
  const auto byEdges = coarsest(picture(effect, floor));
  multiResolution_.settings().mask.minMaxMips = true;
  EXPECT_LT(coarsest(picture(effect, floor)), byEdges);
  EXPECT_THAT(picture(effect, plane({0.0, 0.0, 1.0}, -6.0)), testing::Each(kCoarsest));
}

TEST_F(MinMaxPictures, AreLimitedByImportanceAtEveryLevel) {
  TestEffect effect(levelNumbers());
  constexpr float kNone = 0.0f;
  const gl::Texture2D nothing(GL_R32F, {1, 1}, "test.importance", 1, &kNone);
  EXPECT_EQ(picture(effect, room(), &nothing), picture(effect, room()));
  multiResolution_.settings().mask.combination = kCombineByMinimum;
  EXPECT_THAT(picture(effect, room(), &nothing), testing::Each(kCoarsest));
}

TEST_F(MinMaxPictures, ReplaceTheGeometryEdgesOfAPreviewAlone) {
  TestEffect::Recipe recipe = levelNumbers();
  recipe.preview = "return vec2(surface.pixel.x < 100.0 ? 0.0 : 1.0);";
  TestEffect effect(recipe);
  const Picture previewed = picture(effect, room());
  multiResolution_.settings().mask.minMaxMips = false;
  EXPECT_EQ(picture(effect, room()), previewed) << "the effect's edges alone are asked for";
  multiResolution_.settings().mask.minMaxMips = true;
  multiResolution_.settings().mask.geometryAlways = true;
  const Picture both = picture(effect, room());
  EXPECT_NE(both, previewed);
  for (std::size_t i = 0; i < both.size(); ++i) ASSERT_LE(both[i], previewed[i]) << i;
}

TEST_F(MinMaxPictures, HaveNothingUndefinedNorAllocate) {
  TestEffect effect({.body = "return vec4(fract(surface.position.x));", .filtered = true});
  const SyntheticGBuffer gbuffer(size_, perspective(size_), room());
  for (unsigned levels = 3; levels < 16; levels += 2) {
    effect.setLevels(levelSubset(levels));
    const Picture clean = renderPicture(multiResolution_, effect, gbuffer.frame());
    multiResolution_.fillTargets(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(renderPicture(multiResolution_, effect, gbuffer.frame()), clean) << levels;
    EXPECT_TRUE(isFinite(clean));
    const AllocationCounter allocations;
    multiResolution_.render(effect, gbuffer.frame());
    EXPECT_EQ(allocations.count(), 0u);
  }
}

}  // namespace
}  // namespace mres::test
