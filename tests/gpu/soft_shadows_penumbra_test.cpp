// The penumbras of soft shadows: how wide they are, and that they alone are refined.
#include <cstddef>
#include <gmock/gmock.h>
#include <vector>

#include "effects/soft_shadows/soft_shadows.h"
#include "mres/mres.h"
#include "tests/gpu/soft_shadows_support.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/synthetic_shadow.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

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
  Penumbra() { refineByMasks(multiResolution_); }

  /// Which of the levels' colours each pixel has.
  Image levelsOf(Effect& effect, const Frame& frame, Technique technique) {
    multiResolution_.settings().technique = technique;
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
    const Image levels = levelsOf(unfiltered, gbuffer.frame(), Technique::paper);
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
    for (const Technique technique : {Technique::paper, Technique::multiResolution})
      EXPECT_THAT(levelsOf(effect_, gbuffer.frame(), technique).texels, testing::Each(0.0f));
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

}  // namespace
}  // namespace mres::test
