// What soft shadows must mean.
#include "effects/soft_shadows/soft_shadows.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "mres/mres.h"
#include "tests/gpu/soft_shadows_support.h"
#include "tests/support/allocations.h"
#include "tests/support/pictures.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/synthetic_shadow.h"

namespace mres::test {
namespace {

glm::dvec3 atAngle(double degrees, double azimuth) {
  const double angle = glm::radians(degrees);
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

class LitPlane : public SoftShadowsTest {
 protected:
  /// By a wide filter and by the default one, the latter also at coarser levels; with PCSS and without.
  void expectLit(const SyntheticLight& light) {
    const SyntheticShadow shadow(wall_, light, kMapSize);
    effect_.setInputs(shadow.inputs());
    for (const bool pcss : {false, true}) {
      expectLitBy({.samples = 64, .filterRadius = 0.2f, .contactHardening = pcss}, Technique::full);
      for (const Technique technique : {Technique::full, Technique::multiResolution})
        expectLitBy({.contactHardening = pcss}, technique);
    }
  }

 private:
  void expectLitBy(const SoftShadowSettings& settings, Technique technique) {
    effect_.setSettings(settings);
    multiResolution_.settings().technique = technique;
    EXPECT_THAT(renderPicture(multiResolution_, effect_, gbuffer_.frame()), testing::Each(1.0f))
        << "radius " << settings.filterRadius << ", PCSS " << settings.contactHardening << ", technique "
        << static_cast<int>(technique);
  }

  RayCaster wall_ = plane({0.0, 0.0, 1.0}, -5.0);
  SyntheticGBuffer gbuffer_{kSize, perspective(kSize), wall_};
};

TEST_F(LitPlane, IsLitByASunAtEveryAngle) {
  for (const double degrees : {0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 88.0, 88.5, 89.0, 89.9}) {
    for (const double azimuth : {0.0, 0.7, 2.0, 4.0}) {
      SCOPED_TRACE(testing::Message() << degrees << " degrees, azimuth " << azimuth);
      expectLit(parallelLight(atAngle(degrees, azimuth), {0.0, 0.0, -5.0}, 8.0f));
    }
  }
}

TEST_F(LitPlane, IsLitByALampAtEveryAngle) {
  expectLit(spotLight({1.0, 0.5, -2.0}, {0.0, 0.0, -5.0}));
  // At 88 degrees it is a decimetre over the wall: the far side of the picture has light at less than one.
  const glm::dvec3 middle(0.0, 0.0, -5.0);
  for (const double degrees : {45.0, 75.0, 85.0, 88.0}) {
    for (const double azimuth : {0.7, 4.0}) {
      SCOPED_TRACE(testing::Message() << degrees << " degrees, azimuth " << azimuth);
      expectLit(spotLight(middle + 3.0 * atAngle(degrees, azimuth), middle));
    }
  }
}

glm::ivec2 pixelAt(glm::dvec3 position, glm::ivec2 size = kSize) {
  return pixelOf(perspective(size), size, position);
}

TEST_F(SoftShadowsTest, ABoxIsDarkAtItsContactAndItsShadowEndsWhereGeometrySays) {
  // From +x at 45 degrees: the box, a metre high, shades the floor from x = -1 to x = -2.
  const SyntheticLight sun = parallelLight({1.0, 0.0, 1.0}, {0.0, 0.0, -6.0}, 8.0f);
  for (const bool pcss : {false, true}) {
    const Image image = render(floorWithBox(), sun, {.filterRadius = 0.1f, .contactHardening = pcss});
    for (const double x : {-1.25, -1.5, -1.7}) EXPECT_LT(image.at(pixelAt({x, 0.0, -6.0})), 0.02f) << x;
    for (const double x : {-2.4, -3.0, 1.4}) EXPECT_EQ(image.at(pixelAt({x, 0.0, -6.0})), 1.0f) << x;
    EXPECT_EQ(image.at(pixelAt({0.0, 0.0, -5.0})), 1.0f) << "the box's top";
  }
}

TEST_F(SoftShadowsTest, AShadowBeginsAtTheContact) {
  // The box's side at x = -1 is seen down to the floor, where a pixel is less than two centimetres, a texel
  // one.
  const RayCaster scene = nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-3.0, -1.0, -7.0}, {-1.0, 1.0, -5.0})});
  const glm::ivec2 size = 5 * kSize;
  const SyntheticLight sun = parallelLight({-1.0, 0.0, 1.0}, {-1.0, 0.0, -6.0}, 2.0f);
  for (const bool pcss : {false, true}) {
    const Image image = render(scene, sun, {.filterRadius = 0.1f, .contactHardening = pcss}, size);
    for (const double x : {-0.97, -0.95, -0.9}) {
      EXPECT_LT(image.at(pixelAt({x, 0.0, -6.0}, size)), 0.02f) << x << ", PCSS " << pcss;
    }
  }
}

TEST_F(SoftShadowsTest, ASpotLightCastsShadowsWherePenumbrasFollowItsSize) {
  // From two metres over the floor; the blocker, at half of the height, ends at x = 0.5: its shadow at x = 1.
  const RayCaster scene =
      nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-20.0, -20.0, -5.02}, {0.5, 20.0, -5.0})});
  const SyntheticLight spot = spotLight({0.0, 0.0, -4.0}, {0.0, 0.0, -6.0});
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), plane({0.0, 0.0, 1.0}, -6.0));
  const SyntheticShadow shadow(scene, spot, kMapSize);
  multiResolution_.settings().technique = Technique::full;
  const auto litBy = [&](float lightRadius) {
    effect_.setSettings({.filterRadius = 1.0f, .contactHardening = true, .lightRadius = lightRadius});
    effect_.setInputs(shadow.inputs());
    return Image{kSize, 1, renderPicture(multiResolution_, effect_, gbuffer.frame())};
  };
  const Image small = litBy(0.05f);
  EXPECT_LT(small.at(pixelAt({0.6, 0.0, -6.0})), 0.02f);
  EXPECT_GT(small.at(pixelAt({1.4, 0.0, -6.0})), 0.98f);
  // By similar triangles the penumbra is as wide as the light: blocker and receiver are equally far apart.
  const Image large = litBy(0.3f);
  EXPECT_NEAR(large.at(pixelAt({1.0, 0.0, -6.0})), 0.5f, 0.15f);
  // A chord at 0.45 of the disk's radius cuts off 0.22 of it; the level's filter, 0.4 m wide here, blurs that
  // a little.
  EXPECT_NEAR(large.at(pixelAt({0.85, 0.0, -6.0})), 0.25f, 0.1f);
  EXPECT_NEAR(large.at(pixelAt({1.15, 0.0, -6.0})), 0.75f, 0.1f);
  EXPECT_LT(large.at(pixelAt({0.5, 0.0, -6.0})), 0.02f);
  EXPECT_GT(large.at(pixelAt({1.5, 0.0, -6.0})), 0.98f);
}

TEST_F(SoftShadowsTest, BlockersInfinitelyFarFromASpotLightAreNone) {
  // A projection without a far plane, and a map that shows nothing but the blocker.
  SyntheticLight spot = spotLight({0.0, 0.0, -4.0}, {0.0, 0.0, -6.0});
  spot.projection = glm::infinitePerspective(glm::radians(90.0f), 1.0f, 0.1f);
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), plane({0.0, 0.0, 1.0}, -6.0));
  const SyntheticShadow shadow(box({-0.5, -0.5, -5.1}, {0.5, 0.5, -5.0}), spot, kMapSize);
  effect_.setSettings({.filterRadius = 0.5f, .contactHardening = true});
  effect_.setInputs(shadow.inputs());
  multiResolution_.settings().technique = Technique::full;  // levels may differ from it
  const Image image{kSize, 1, renderPicture(multiResolution_, effect_, gbuffer.frame())};
  EXPECT_LT(image.at(pixelAt({0.0, 0.0, -6.0})), 0.02f);
  EXPECT_LT(image.at(pixelAt({0.75, 0.0, -6.0})), 0.02f) << "the search for blockers sees past them";
  EXPECT_GT(image.at(pixelAt({1.5, 0.0, -6.0})), 0.98f);
}

TEST_F(SoftShadowsTest, NothingIsDarkForLyingAtTheMapsFarEnd) {
  // The floor is tilted against the light, so that filters see beyond the end of the map's depths.
  const RayCaster floor = plane({0.6, 0.0, 1.0}, -6.0);
  SyntheticLight sun = parallelLight({0.0, 0.0, 1.0}, {0.0, 0.0, -6.0}, 8.0f);
  sun.projection = glm::ortho(-8.0f, 8.0f, -8.0f, 8.0f, 0.1f, 20.5f);
  EXPECT_THAT(render(floor, sun, {.filterRadius = 1.0f}).texels, testing::Each(1.0f));
}

TEST_F(SoftShadowsTest, DepthOfSixteenBitsMakesNoAcne) {
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), plane({0.0, 0.3, 1.0}, -20.0),
                                 {.format = GL_DEPTH_COMPONENT16});
  const SyntheticShadow shadow(plane({0.0, 0.3, 1.0}, -20.0),
                               parallelLight({0.3, 0.5, 1.0}, {0.0, 0.0, -20.0}, 30.0f), kMapSize);
  effect_.setSettings({.filterRadius = 0.05f});
  effect_.setInputs(shadow.inputs());
  EXPECT_THAT(renderPicture(multiResolution_, effect_, gbuffer.frame()), testing::Each(1.0f));
}

TEST_F(SoftShadowsTest, WhatFacesAwayIsDarkAndWhatTheMapDoesNotCoverIsLit) {
  const RayCaster wall = plane({0.0, 0.0, 1.0}, -5.0);
  const Image away = render(wall, parallelLight({0.3, 0.0, -1.0}, {0.0, 0.0, -5.0}, 8.0f), {});
  EXPECT_THAT(away.texels, testing::Each(0.0f));
  const Image outside = render(floorWithBox(), parallelLight({1.0, 0.0, 1.0}, {30.0, 0.0, -6.0}, 2.0f), {});
  EXPECT_EQ(outside.at(pixelAt({-1.3, 0.0, -6.0})), 1.0f);
}

TEST_F(SoftShadowsTest, WithoutAMapEverythingIsLit) {
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), room());
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    multiResolution_.settings().technique = technique;
    EXPECT_THAT(renderPicture(multiResolution_, effect_, gbuffer.frame()), testing::Each(1.0f));
  }
}

TEST_F(SoftShadowsTest, TheFewestAndTheMostSamplesShowTheSameShadow) {
  const SyntheticLight sun = parallelLight({1.0, 0.0, 1.0}, {0.0, 0.0, -6.0}, 8.0f);
  for (const int samples : {1, 2, kMaxSoftShadowSamples}) {
    const Image image = render(floorWithBox(), sun, {.samples = samples, .filterRadius = 0.1f});
    EXPECT_LT(image.at(pixelAt({-1.5, 0.0, -6.0})), 0.02f) << samples;
    EXPECT_EQ(image.at(pixelAt({-2.4, 0.0, -6.0})), 1.0f) << samples;
  }
}

TEST_F(SoftShadowsTest, ASteadyFrameAllocatesNothing) {
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), room());
  const SyntheticShadow shadow(room(), parallelLight({0.5, 1.0, 0.7}, {0.0, 0.0, -5.0}, 9.0f), {64, 64});
  const auto renderFrame = [&] {
    effect_.setInputs(shadow.inputs());
    multiResolution_.render(effect_, gbuffer.frame());
  };
  for (int frame = 0; frame < 3; ++frame) renderFrame();
  const AllocationCounter allocations;
  for (int frame = 0; frame < 3; ++frame) renderFrame();
  EXPECT_EQ(allocations.count(), 0u);
}

TEST_F(SoftShadowsTest, RefusesWhatCannotBeUsed) {
  for (const int samples : {0, kMaxSoftShadowSamples + 1}) {
    EXPECT_THAT([&] { effect_.setSettings({.samples = samples}); }, refusesInASentence("samples"));
  }
  EXPECT_THAT([&] { effect_.setSettings({.filterRadius = std::nanf("")}); },
              refusesInASentence("filterRadius"));
  EXPECT_THAT([&] { effect_.setInputs({.shadowMap = 1, .mapSize = {0, 5}}); }, refusesInASentence("mapSize"));
  EXPECT_THAT(
      [&] {
        effect_.setInputs({.shadowMap = 1, .mapSize = {8, 8}, .shadowFromView = glm::mat4(std::nanf(""))});
      },
      refusesInASentence("shadowFromView"));
}

}  // namespace
}  // namespace mres::test
