// What soft shadows must mean, and their filter against double precision.
#include "effects/soft_shadows/soft_shadows.h"

#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "effects/soft_shadows/disk_samples.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_test.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_shadow.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

const glm::ivec2 kSize(97, 73);
const glm::ivec2 kMapSize(512, 512);

class SoftShadowsTest : public GlTest {
 protected:
  Image render(const RayCaster& scene, const SyntheticLight& light, const SoftShadowSettings& settings,
               glm::ivec2 size = kSize) {
    const SyntheticGBuffer gbuffer(size, perspective(size), scene);
    const SyntheticShadow shadow(scene, light, kMapSize);
    multiResolution_.settings().technique = Technique::full;
    effect_.setSettings(settings);
    effect_.setInputs(shadow.inputs());
    return {size, 1, renderPicture(multiResolution_, effect_, gbuffer.frame())};
  }

  MultiResolution multiResolution_;
  SoftShadows effect_;
};

glm::dvec3 atAngle(double degrees, double azimuth) {
  const double angle = glm::radians(degrees);
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

TEST_F(SoftShadowsTest, ALitPlaneIsLitAtEveryAngle) {
  const RayCaster wall = plane({0.0, 0.0, 1.0}, -5.0);
  for (const bool pcss : {false, true}) {
    for (const double degrees : {0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 88.0, 88.5, 89.0, 89.9}) {
      for (const double azimuth : {0.0, 0.7, 2.0, 4.0}) {
        const SyntheticLight sun = parallelLight(atAngle(degrees, azimuth), {0.0, 0.0, -5.0}, 8.0f);
        const Image image =
            render(wall, sun, {.samples = 64, .filterRadius = 0.2f, .contactHardening = pcss});
        EXPECT_THAT(image.texels, testing::Each(1.0f)) << degrees << " degrees, PCSS " << pcss;
      }
    }
    const Image image = render(wall, spotLight({1.0, 0.5, -2.0}, {0.0, 0.0, -5.0}),
                               {.samples = 64, .filterRadius = 0.2f, .contactHardening = pcss});
    EXPECT_THAT(image.texels, testing::Each(1.0f)) << "spot light, PCSS " << pcss;
  }
}

/// A floor a metre below the eye, seen from above.
RayCaster floorWithBox() {
  return nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-1.0, -1.0, -7.0}, {1.0, 1.0, -5.0})});
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
  EXPECT_GT(large.at(pixelAt({0.85, 0.0, -6.0})), 0.02f);
  EXPECT_LT(large.at(pixelAt({1.15, 0.0, -6.0})), 0.98f);
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

/// How many pixels of a row lie in the penumbra.
int penumbraPixels(const Image& image, int y) {
  int count = 0;
  for (int x = 0; x < image.size.x; ++x) {
    const float value = image.at({x, y});
    count += value > 0.02f && value < 0.98f ? 1 : 0;
  }
  return count;
}

TEST_F(SoftShadowsTest, WithContactHardeningPenumbrasWidenWithTheBlockersDistance) {
  const auto blockerAt = [](double height) {
    return nearest(
        {plane({0.0, 0.0, 1.0}, -6.0), box({-20.0, -20.0, -6.0 + height}, {0.5, 20.0, -5.9 + height})});
  };
  const SyntheticLight sun = parallelLight({-1.0, 0.0, 2.0}, {0.0, 0.0, -6.0}, 8.0f);
  const SoftShadowSettings soft{.filterRadius = 2.0f, .contactHardening = true, .lightAngle = 40.0f};
  const int near = penumbraPixels(render(blockerAt(0.3), sun, soft), kSize.y / 2);
  const int far = penumbraPixels(render(blockerAt(2.0), sun, soft), kSize.y / 2);
  EXPECT_GT(near, 0);
  EXPECT_GT(far, 5 * near / 2);
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

/// A floor and a wall, and casters before them: a room's own walls would shade everything.
struct LitScene {
  const char* name;
  RayCaster receivers;
  RayCaster casters;
  SyntheticLight light;
  SoftShadowSettings settings;
};

std::vector<LitScene> scenesWithPenumbras() {
  const RayCaster things = nearest({plane({0.0, 1.0, 0.0}, -1.5), sphere({-1.0, 0.0, -4.0}, 0.5),
                                    box({0.3, -1.0, -5.0}, {1.2, 0.5, -4.2})});
  const RayCaster slab = nearest({plane({0.0, 1.0, 0.0}, -1.5), box({-1.0, -1.5, -5.0}, {1.0, -1.47, -4.0})});
  const SyntheticLight sun = parallelLight({0.5, 1.0, 0.7}, {0.0, 0.0, -5.0}, 9.0f);
  const SyntheticLight nearSun = parallelLight({0.5, 0.4, 0.7}, {0.0, -1.5, -4.5}, 2.5f);
  const SoftShadowSettings pcss{
      .samples = 64, .filterRadius = 0.5f, .contactHardening = true, .lightAngle = 8.0f, .lightRadius = 0.2f};
  return {{"PCF", room(), things, sun, {.samples = 64, .filterRadius = 0.25f}},
          {"PCSS", room(), things, sun, pcss},
          {"PCSS, a slab of 3 cm", slab, slab, nearSun, pcss},
          {"spot light", room(), things, spotLight({1.0, 2.0, -2.0}, {0.0, -1.0, -5.0}), pcss}};
}

class Penumbra : public SoftShadowsTest {
 protected:
  Penumbra() { refineAtEveryEdge(multiResolution_); }

  /// Which of the levels' colours each pixel has.
  Image levelsOf(Effect& effect, const Frame& frame) {
    multiResolution_.settings().technique = Technique::multiResolution;
    static_cast<void>(renderPicture(multiResolution_, effect, frame));
    return {frame.size, 3, readPixels(multiResolution_.debugView(DebugView::levels), frame.size, 3)};
  }
};

TEST_F(Penumbra, IsRefined) {
  const glm::ivec2 size(320, 240);
  for (const LitScene& scene : scenesWithPenumbras()) {
    const SyntheticGBuffer gbuffer(size, perspective(size), scene.receivers);
    const SyntheticShadow shadow(scene.casters, scene.light, kMapSize);
    Unfiltered<SoftShadows> unfiltered(scene.settings);
    unfiltered.effect().setInputs(shadow.inputs());
    multiResolution_.settings().technique = Technique::full;
    const Image full{size, 1, renderPicture(multiResolution_, unfiltered, gbuffer.frame())};
    const Image levels = levelsOf(unfiltered, gbuffer.frame());
    int penumbra = 0;
    int coarse = 0;
    for (int i = 0; i < size.x * size.y; ++i) {
      const glm::ivec2 pixel(i % size.x, i / size.x);
      if (full.at(pixel) < 0.05f || full.at(pixel) > 0.95f) continue;
      ++penumbra;
      coarse += levels.at(pixel, 0) < 0.5f ? 1 : 0;  // full resolution is red
    }
    EXPECT_GT(penumbra, 200) << scene.name;
    EXPECT_LE(coarse, penumbra / 100) << scene.name;
  }
}

TEST_F(Penumbra, IsAllThatIsRefined) {
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), floorWithBox());
  const RayCaster roof = nearest({plane({0.0, 0.0, 1.0}, -1.0), plane({0.0, 0.0, 1.0}, -6.0)});
  const SyntheticLight above = parallelLight({0.0, 0.1, 1.0}, {0.0, 0.0, -6.0}, 8.0f);
  const SyntheticLight below = parallelLight({0.0, 0.1, -1.0}, {0.0, 0.0, -6.0}, 8.0f);
  const SyntheticShadow lit(plane({0.0, 0.0, 1.0}, -8.0), above, kMapSize);
  const SyntheticShadow dark(roof, above, kMapSize);
  const SyntheticShadow behind(plane({0.0, 0.0, 1.0}, -4.0), below, kMapSize);
  for (const SyntheticShadow* shadow : {&lit, &dark, &behind}) {
    effect_.setInputs(shadow->inputs());
    EXPECT_THAT(levelsOf(effect_, gbuffer.frame()).texels, testing::Each(0.0f));
  }
}

TEST_F(SoftShadowsTest, PenumbrasAreCloseToThoseOfFullResolutionByDefault) {
  const glm::ivec2 size(320, 240);
  for (const LitScene& scene : scenesWithPenumbras()) {
    const SyntheticGBuffer gbuffer(size, perspective(size), scene.receivers);
    const SyntheticShadow shadow(scene.casters, scene.light, kMapSize);
    effect_.setSettings(scene.settings);
    effect_.setInputs(shadow.inputs());
    const auto renderBy = [&](Technique technique) {
      multiResolution_.settings().technique = technique;
      return renderPicture(multiResolution_, effect_, gbuffer.frame());
    };
    const Picture full = renderBy(Technique::full);
    const Picture mixed = renderBy(Technique::multiResolution);
    Picture fullPenumbra;
    Picture mixedPenumbra;
    for (std::size_t i = 0; i < full.size(); ++i) {
      if (full[i] < 0.05f || full[i] > 0.95f) continue;
      fullPenumbra.push_back(full[i]);
      mixedPenumbra.push_back(mixed[i]);
    }
    EXPECT_GT(fullPenumbra.size(), 200u) << scene.name;
    EXPECT_LT(rootMeanSquare(mixedPenumbra, fullPenumbra), 0.03) << scene.name;
  }
}

/// Percentage-closer filtering written anew: light rays through texel centres meet the receiver's plane.
class FilterReference {
 public:
  FilterReference(const SyntheticShadow& shadow, const SoftShadowSettings& settings)
      : shadow_(shadow), settings_(settings), samples_(diskSamples(settings.samples, settings.seed)) {}

  [[nodiscard]] double visibility(glm::dvec3 position, glm::dvec3 normal, double azimuth) const {
    const glm::dmat4 mapFromView(shadow_.inputs().shadowFromView);
    const glm::dvec2 centre = texelOf(mapFromView, position);
    const glm::dmat2 turn(std::cos(azimuth), std::sin(azimuth), -std::sin(azimuth), std::cos(azimuth));
    const double metresPerTexel = 1.0 / glm::length(texelOf(mapFromView, position + across()) - centre);
    const double radius = static_cast<double>(settings_.filterRadius) / metresPerTexel;
    int lit = 0;
    for (const glm::vec2 sample : samples_) {
      const glm::ivec2 texel(glm::floor(centre + turn * glm::dvec2(sample) * radius));
      const double depth = planeDepth(mapFromView, texel, position, normal);
      lit += shadow_.depth(texel) >= depth ? 1 : 0;
    }
    return static_cast<double>(lit) / settings_.samples;
  }

 private:
  [[nodiscard]] glm::dvec2 texelOf(const glm::dmat4& mapFromView, glm::dvec3 position) const {
    const glm::dvec4 clip = mapFromView * glm::dvec4(position, 1.0);
    return glm::dvec2(clip) / clip.w * glm::dvec2(shadow_.inputs().mapSize);
  }

  /// A metre across the light, towards increasing u.
  [[nodiscard]] glm::dvec3 across() const {
    return glm::normalize(glm::dvec3(glm::row(glm::dmat4(shadow_.inputs().shadowFromView), 0)));
  }

  /// Depth, in the map, of the plane raised by the bias, where the light ray of a texel's centre meets it.
  [[nodiscard]] double planeDepth(const glm::dmat4& mapFromView, glm::ivec2 texel, glm::dvec3 position,
                                  glm::dvec3 normal) const {
    const glm::dmat4 viewFromMap = glm::inverse(mapFromView);
    const glm::dvec2 place = (glm::dvec2(texel) + 0.5) / glm::dvec2(shadow_.inputs().mapSize);
    const auto at = [&](double depth) {
      const glm::dvec4 point = viewFromMap * glm::dvec4(place, depth, 1.0);
      return glm::dvec3(point) / point.w;
    };
    const glm::dvec3 near = at(0.0);
    const glm::dvec3 far = at(1.0);
    const glm::dvec3 raised =
        position + normal * static_cast<double>(settings_.bias) * static_cast<double>(settings_.filterRadius);
    const double share = glm::dot(raised - near, normal) / glm::dot(far - near, normal);
    return (mapFromView * glm::dvec4(glm::mix(near, far, share), 1.0)).z;
  }

  const SyntheticShadow& shadow_;
  SoftShadowSettings settings_;
  std::vector<glm::vec2> samples_;
};

TEST_F(SoftShadowsTest, TheFilterAgreesWithDoublePrecision) {
  // A wall with boxes before it, lit well within the slopes for which the disk keeps its size.
  const RayCaster scene = nearest({plane({0.2, 0.1, 1.0}, -6.0), box({-1.5, -1.0, -5.5}, {-0.7, 0.6, -4.0}),
                                   box({0.2, -0.5, -5.0}, {0.9, 1.1, -4.5}), sphere({1.4, -1.0, -4.6}, 0.4)});
  const SyntheticLight sun = parallelLight({0.7, 0.5, 1.0}, {0.0, 0.0, -5.5}, 6.0f);
  const SoftShadowSettings settings{.samples = 31, .filterRadius = 0.15f, .seed = 3};
  const SyntheticShadow shadow(scene, sun, kMapSize);
  const FilterReference reference(shadow, settings);
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), scene);
  Unfiltered<SoftShadows> unfiltered(settings);
  unfiltered.effect().setInputs(shadow.inputs());
  multiResolution_.settings().technique = Technique::full;
  const Image image{kSize, 1, renderPicture(multiResolution_, unfiltered, gbuffer.frame())};

  const glm::dmat4 viewFromClip = glm::inverse(glm::dmat4(perspective(kSize)));
  constexpr int kBayer[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  int compared = 0;
  int different = 0;
  int partly = 0;
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      const auto index = static_cast<std::size_t>(y * kSize.x + x);
      const glm::dvec3 normal(gbuffer.normals()[index]);
      if (glm::dot(normal, glm::normalize(glm::dvec3(0.7, 0.5, 1.0))) < 0.35) continue;  // steeper
      const glm::dvec2 ndc = (glm::dvec2(x, y) + 0.5) / glm::dvec2(kSize) * 2.0 - 1.0;
      const double depth = static_cast<double>(gbuffer.depths()[index]) * 2.0 - 1.0;
      const glm::dvec4 point = viewFromClip * glm::dvec4(ndc, depth, 1.0);
      const double azimuth = kBayer[(y & 3) * 4 + (x & 3)] * glm::radians(22.5);
      const double expected = reference.visibility(glm::dvec3(point) / point.w, normal, azimuth);
      ++compared;
      partly += expected > 0.0 && expected < 1.0 ? 1 : 0;
      different +=
          std::abs(static_cast<double>(image.at({x, y})) - expected) > 0.5 / settings.samples ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(partly, 300) << "there are penumbras";
  EXPECT_LE(different, compared / 50) << "samples on the border of two texels may fall either way";
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
