// What soft shadows must mean, and their filter against double precision.
#include "effects/soft_shadows/soft_shadows.h"

#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <gmock/gmock.h>

#include "effects/soft_shadows/disk_samples.h"
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
               Technique technique = Technique::full) {
    const SyntheticGBuffer gbuffer(kSize, perspective(kSize), scene);
    const SyntheticShadow shadow(scene, light, kMapSize);
    multiResolution_.settings().technique = technique;
    effect_.setSettings(settings);
    effect_.setInputs(shadow.inputs());
    return {kSize, 1, renderPicture(multiResolution_, effect_, gbuffer.frame())};
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
    for (const double degrees : {0.0, 20.0, 45.0, 60.0, 75.0, 85.0, 88.0}) {
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

/// The pixel at which a point is seen.
glm::ivec2 pixelAt(glm::dvec3 position) {
  const glm::dvec4 clip = glm::dmat4(perspective(kSize)) * glm::dvec4(position, 1.0);
  const glm::ivec2 pixel((glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(kSize));
  return pixel;
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

TEST_F(SoftShadowsTest, TheEdgesCoverThePenumbra) {
  const glm::ivec2 size(256, 192);
  const SyntheticLight sun = parallelLight({0.5, 1.0, 0.7}, {0.0, 0.0, -5.0}, 9.0f);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  // The room's own walls would shade everything: only what stands in it casts shadows here.
  const RayCaster casters = nearest({plane({0.0, 1.0, 0.0}, -1.5), sphere({-1.0, 0.0, -4.0}, 0.5),
                                     box({0.3, -1.0, -5.0}, {1.2, 0.5, -4.2})});
  const SyntheticShadow shadow(casters, sun, kMapSize);
  Unfiltered<SoftShadows> unfiltered(SoftShadowSettings{.samples = 64, .filterRadius = 0.25f});
  unfiltered.effect().setInputs(shadow.inputs());
  multiResolution_.settings().technique = Technique::full;
  const Image full{size, 1, renderPicture(multiResolution_, unfiltered, gbuffer.frame())};
  multiResolution_.settings().technique = Technique::multiResolution;
  static_cast<void>(renderPicture(multiResolution_, unfiltered, gbuffer.frame()));
  const Image edges{size, 4, readPixels(multiResolution_.debugView(DebugView::edges), size, 4)};
  int penumbra = 0;
  int uncovered = 0;
  for (int y = 1; y < size.y; y += 2) {
    for (int x = 1; x < size.x; x += 2) {
      const float value = full.at({x, y});
      if (value < 0.05f || value > 0.95f) continue;
      ++penumbra;
      uncovered += edges.at({x, y}, 2) == 0.0f ? 1 : 0;
    }
  }
  EXPECT_GT(penumbra, 200);
  EXPECT_LE(uncovered, penumbra / 100);
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

TEST_F(SoftShadowsTest, RefusesWhatCannotBeUsed) {
  EXPECT_THAT([&] { effect_.setSettings({.samples = 0}); }, refusesInASentence("samples"));
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
