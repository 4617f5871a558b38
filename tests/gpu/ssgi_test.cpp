// What directional occlusion with one bounce must mean, whatever its implementation.
#include "effects/ssgi/ssgi.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "effects/common/sample_points.h"
#include "effects/ssao/ssao.h"
#include "tests/gpu/ssgi_support.h"
#include "tests/support/ssgi_reference.h"

namespace mres::test {
namespace {

constexpr float kHuge = std::numeric_limits<float>::max();

SsgiInputs inAWhiteEnvironment(const LitPicture& lit) {
  return {.radiance = lit.texture.id(), .environmentAbove = kWhite, .environmentBelow = kWhite};
}

TEST_F(SsgiTest, AWhiteFurnaceNeverGivesMoreThanWhite) {
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(2, 3), glm::ivec2(7, 5), glm::ivec2(64, 1),
                                glm::ivec2(1, 64), glm::ivec2(31, 17), glm::ivec2(129, 97)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    const LitPicture lit = uniformPicture(size, kWhite);
    const SsgiInputs inputs = inAWhiteEnvironment(lit);
    for (const Technique technique : {Technique::full, Technique::multiResolution}) {
      for (const int samples : {8, 64, 228, 288, 8192}) {
        const Image image = render(gbuffer, {.samples = samples}, inputs, technique);
        for (const float value : image.texels)
          ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << value << " of " << samples;
      }
    }
  }
}

TEST_F(SsgiTest, WhatAWhiteFurnaceLosesIsTheBacksOfSenders) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), box({-2.137, -1.571, -5.1}, {2.213, 1.419, 1.0}));
  const LitPicture lit = uniformPicture(size, kWhite);
  const SsgiInputs inputs = inAWhiteEnvironment(lit);
  EXPECT_THAT(render(gbuffer, {.samples = 64}, inputs).texels,
              testing::Each(testing::FloatNear(1.0f, 0.001f)))
      << "inside of an empty box nothing shows its back";
}

TEST_F(SsgiTest, WithoutALitPictureAWhiteEnvironmentIsAmbientOcclusion) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const Image image =
      render(gbuffer, {.samples = 64}, {.environmentAbove = kWhite, .environmentBelow = kWhite});
  Ssao ssao({.radius = 1.0f, .samples = 64});
  const Picture accessibility = renderPicture(multiResolution_, ssao, gbuffer.frame());
  EXPECT_LT(*std::ranges::min_element(accessibility), 0.5f);
  for (std::size_t i = 0; i < accessibility.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      ASSERT_NEAR(image.texels[3 * i + channel], accessibility[i], 0.002) << i;
    }
  }
}

TEST_F(SsgiTest, WithoutALitPictureAndAnEnvironmentIsNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const int samples : {16, 1600}) {
    EXPECT_THAT(render(gbuffer, {.samples = samples}, {}).texels, testing::Each(0.0f)) << samples;
  }
}

TEST_F(SsgiTest, APlaneAloneGivesTheMeanOfTheEnvironment) {
  const glm::ivec2 size(129, 97);
  const LitPicture lit = uniformPicture(size, kWhite);
  const SsgiInputs inputs{.radiance = lit.texture.id(),
                          .environmentAbove = {1.0f, 0.5f, 0.25f},
                          .environmentBelow = {0.0f, 0.5f, 0.75f},
                          .up = glm::normalize(glm::vec3(0.1f, 0.9f, 0.3f))};
  double cosine = 0.0;
  for (const glm::dvec3 point : hemispherePoints(64, 0)) cosine += glm::normalize(point).z / 64.0;
  EXPECT_NEAR(cosine, 2.0 / 3.0, 0.01) << "the cosine-weighted mean of a cosine";
  for (const glm::dvec3 normal : {glm::dvec3(0.0, 1.0, 0.1), glm::dvec3(0.5, -0.7, 1.0)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), plane(normal, -1.0 * normal.z - 1.0));
    const double height = cosine * glm::dot(glm::normalize(normal), glm::dvec3(inputs.up));
    const glm::dvec3 expected = glm::mix(glm::dvec3(inputs.environmentBelow),
                                         glm::dvec3(inputs.environmentAbove), 0.5 + 0.5 * height);
    const Image image = render(gbuffer, {.samples = 64}, inputs);
    int surfaces = 0;
    for (int i = 0; i < size.x * size.y; ++i) {
      if (gbuffer.depths()[static_cast<std::size_t>(i)] == 1.0f) continue;
      ++surfaces;
      const glm::ivec2 pixel(i % size.x, i / size.x);
      for (int channel = 0; channel < 3; ++channel) {
        ASSERT_NEAR(image.at(pixel, channel), expected[channel], 0.002) << pixel.x << ", " << pixel.y;
      }
    }
    EXPECT_GT(surfaces, size.x * size.y / 3);
  }
}

TEST_F(SsgiTest, APlaneInAWhiteFurnaceIsExactlyWhite) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.2, 0.3, 1.0}, -5.0));
  const LitPicture lit = uniformPicture(size, kWhite);
  const SsgiInputs inputs = inAWhiteEnvironment(lit);
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    EXPECT_THAT(render(gbuffer, {}, inputs, technique).texels, testing::Each(1.0f));
  }
}

TEST_F(SsgiTest, ARedWallTintsTheFloorBesideItAndNothingFarAway) {
  const glm::ivec2 size(480, 360);
  const glm::mat4 projection = perspective(size);
  const SyntheticGBuffer gbuffer(size, projection,
                                 nearest({plane({0.0, 1.0, 0.0}, -1.0), plane({0.0, 0.0, 1.0}, -5.0)}));
  const LitPicture lit = facingPicture(gbuffer, {0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f}, kWhite);
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    const Image image = render(gbuffer, {.samples = 64}, {.radiance = lit.texture.id()}, technique);
    // Beside the red light so much is too little contrast to refine for.
    const float nothing = technique == Technique::full ? 0.0f : 0.02f;
    float before = 1.0f;
    for (const double distance : {0.25, 0.5, 0.75}) {
      const glm::ivec2 pixel = pixelOf(projection, size, {0.0, -1.0, -5.0 + distance});
      EXPECT_GT(image.at(pixel, 0), 0.003f) << distance << " m from the wall";
      EXPECT_LT(image.at(pixel, 0), before) << distance << " m from the wall";
      EXPECT_LE(image.at(pixel, 1), nothing) << "no green comes from the wall";
      before = image.at(pixel, 0);
    }
    EXPECT_GT(image.at(pixelOf(projection, size, {0.0, -1.0, -4.75}), 0), 0.1f);
    EXPECT_LE(image.at(pixelOf(projection, size, {0.0, -1.0, -2.7}), 0), nothing);
    EXPECT_GT(image.at(pixelOf(projection, size, {0.0, -0.85, -5.0}), 1), 0.1f)
        << "the white floor lights the foot of the wall";
  }
}

// A screen that stands before a wall hides what is before it from the wall, which it shows its back.
TEST_F(SsgiTest, SendersThatFaceAwaySendNothing) {
  const glm::ivec2 size(240, 180);
  const glm::mat4 projection = perspective(size);
  const SyntheticGBuffer gbuffer(size, projection,
                                 nearest({plane({0.0, 1.0, 0.0}, -1.0), plane({0.0, 0.0, 1.0}, -4.0),
                                          box({-1.5, -1.0, -3.05}, {1.5, -0.5, -3.0})}));
  const LitPicture lit = facingPicture(gbuffer, {0.0f, 0.0f, 1.0f}, kWhite, glm::vec3(0.0f));
  const SsgiSettings settings{.radius = 1.2f, .samples = 64};
  const glm::ivec2 behind = pixelOf(projection, size, {0.0, -0.55, -4.0});
  const glm::ivec2 before = pixelOf(projection, size, {0.0, -1.0, -2.7});
  const Image bounced = render(gbuffer, settings, {.radiance = lit.texture.id()});
  EXPECT_EQ(bounced.at(behind), 0.0f);
  EXPECT_GT(bounced.at(before), 0.05f);
  const Image open = render(gbuffer, settings, {.environmentAbove = kWhite, .environmentBelow = kWhite});
  EXPECT_LT(open.at(behind), 0.9f) << "it is blocked there";
}

/// Surfaces whose normals are zero.
RayCaster withoutNormals(RayCaster scene) {
  return [scene = std::move(scene)](glm::dvec3 origin, glm::dvec3 direction) {
    std::optional<Hit> hit = scene(origin, direction);
    if (hit) hit->normal = glm::dvec3(0.0);
    return hit;
  };
}

TEST_F(SsgiTest, SendersWithoutANormalSendNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(
      size, perspective(size),
      nearest({plane({0.0, 1.0, 0.0}, -1.0), withoutNormals(plane({0.0, 0.0, 1.0}, -4.0))}));
  const LitPicture lit = uniformPicture(size, kWhite);
  EXPECT_THAT(render(gbuffer, {.samples = 16}, {.radiance = lit.texture.id()}).texels, testing::Each(0.0f));
}

TEST_F(SsgiTest, WithoutIntensityNothingBounces) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LitPicture lit = uniformPicture(size, kWhite);
  EXPECT_EQ(render(gbuffer, {.samples = 16, .intensity = 0.0f},
                   {.radiance = lit.texture.id(), .environmentAbove = kWhite})
                .texels,
            render(gbuffer, {.samples = 16}, {.environmentAbove = kWhite}).texels);
}

// A texel of a mip of depth has the place of one of its pixels: what is sent must not depend on whether a
// highlight lies in just that one.
TEST_F(SsgiTest, AHighlightOfOnePixelSendsAsMuchWhereverItIs) {
  const glm::ivec2 size(480, 360);
  const glm::mat4 projection = perspective(size);
  const SyntheticGBuffer gbuffer(size, projection,
                                 nearest({plane({0.0, 1.0, 0.0}, -1.0), plane({0.0, 0.0, 1.0}, -3.0)}));
  const glm::ivec2 block = pixelOf(projection, size, {0.0, -0.6, -3.0}) / 8 * 8;
  std::vector<double> sums;
  for (int i = 0; i < 8; ++i) {
    const LitPicture lit(size, [&](glm::ivec2 pixel) { return glm::vec3(pixel == block + i ? 8.0f : 0.0f); });
    const Image image = render(gbuffer, {.samples = 64}, {.radiance = lit.texture.id()});
    sums.push_back(std::accumulate(image.texels.begin(), image.texels.end(), 0.0));
  }
  const auto [least, most] = std::ranges::minmax(sums);
  EXPECT_GT(least, 0.0);
  EXPECT_LT(most, 2.0 * least);
}

TEST_F(SsgiTest, RadianceThatIsNoNumberSendsNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const Image dark = render(gbuffer, {.samples = 16}, {.environmentAbove = kWhite});
  for (const float bad : {kNan, kInfinity, -kInfinity, -1.0f}) {
    const LitPicture lit = uniformPicture(size, glm::vec3(bad));
    const Image image =
        render(gbuffer, {.samples = 16}, {.radiance = lit.texture.id(), .environmentAbove = kWhite});
    EXPECT_EQ(image.texels, dark.texels) << bad;
  }
}

TEST_F(SsgiTest, RadianceIsBoundedByItsMaximum) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const SsgiSettings settings{.samples = 16, .intensity = 4.0f, .maxRadiance = 3.0f};
  const LitPicture three = uniformPicture(size, glm::vec3(3.0f));
  const Image expected = render(gbuffer, settings, {.radiance = three.texture.id()});
  EXPECT_GT(*std::ranges::max_element(expected.texels), 3.0f);
  for (const float large : {3.5f, 1e30f, kHuge}) {
    const LitPicture lit = uniformPicture(size, glm::vec3(large));
    for (const float scale : {1.0f, 65504.0f}) {
      const Image image = render(gbuffer, settings, {.radiance = lit.texture.id(), .radianceScale = scale});
      EXPECT_EQ(image.texels, expected.texels) << large << " times " << scale;
    }
  }
}

TEST_F(SsgiTest, SinglePixelsOfAnyValueLeaveEverythingFiniteAndBounded) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  constexpr std::array kValues = {kNan, kInfinity, 0.5f, kHuge, -kHuge, 1.0f, 1e-40f};
  const LitPicture lit(size, [&](glm::ivec2 pixel) {
    const auto index = static_cast<std::size_t>(pixel.x + 3 * pixel.y);
    return glm::vec3(kValues.at(index % 7), kValues.at((index + 1) % 7), kValues.at((index + 2) % 7));
  });
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    const Image image = render(gbuffer, {.samples = 32}, {.radiance = lit.texture.id()}, technique);
    for (const float value : image.texels) ASSERT_TRUE(value >= 0.0f && value <= 8.0f) << value;
  }
}

TEST_F(SsgiTest, TheSkyHasWhatTheOpenReceivesAndHidesNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), sphere({0.0, 0.0, -3.0}, 1.0));
  const LitPicture lit = uniformPicture(size, glm::vec3(5.0f));
  SsgiInputs inputs = inAWhiteEnvironment(lit);
  EXPECT_THAT(render(gbuffer, {.samples = 16}, inputs).texels, testing::Each(1.0f));
  inputs.environmentBelow = glm::vec3(0.25f);
  const SyntheticGBuffer sky(size, perspective(size), nearest({}));
  EXPECT_THAT(render(sky, {.samples = 16}, inputs, Technique::multiResolution).texels, testing::Each(0.625f));
}

TEST_F(SsgiTest, WithoutReachThereIsTheEnvironmentAlone) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LitPicture lit = uniformPicture(size, glm::vec3(5.0f));
  const SsgiInputs inputs = inAWhiteEnvironment(lit);
  EXPECT_THAT(render(gbuffer, {.radius = 0.0f, .samples = 16}, inputs).texels, testing::Each(1.0f));
}

TEST_F(SsgiTest, EveryNumberOfSamplesAgrees) {
  const glm::ivec2 size(65, 41);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const LitPicture lit = uniformPicture(size, {1.0f, 0.5f, 0.25f});
  const SsgiInputs inputs{.radiance = lit.texture.id(), .environmentAbove = kWhite};
  const Image many = render(gbuffer, {.samples = 8192}, inputs);
  EXPECT_LT(rootMeanSquare(render(gbuffer, {.samples = 8}, inputs).texels, many.texels), 0.1);
  for (const int samples : {228, 1024, 1025, 4224}) {
    EXPECT_LT(rootMeanSquare(render(gbuffer, {.samples = samples}, inputs).texels, many.texels), 0.01)
        << samples;
  }
}

}  // namespace
}  // namespace mres::test
