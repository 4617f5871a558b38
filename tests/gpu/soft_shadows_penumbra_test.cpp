// The penumbras of soft shadows: how wide they are, and that they alone are refined.
#include <algorithm>
#include <cmath>
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

/// Of each column.
std::vector<double> meansOfColumns(const Image& image) {
  std::vector<double> means(static_cast<std::size_t>(image.size.x));
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x; ++x)
      means[static_cast<std::size_t>(x)] += static_cast<double>(image.at({x, y})) / image.size.y;
  return means;
}

/// Where values that grow pass another one, in columns. Throws std::out_of_range if they begin beyond it.
double placeOf(double value, const std::vector<double>& growing) {
  const auto beyond = std::ranges::find_if(growing, [=](double one) { return one >= value; });
  const auto column = static_cast<std::size_t>(beyond - growing.begin());
  const double before = growing.at(column - 1);
  return static_cast<double>(column) - (growing.at(column) - value) / (growing.at(column) - before);
}

/// A floor across the view, before which a caster's shadow ends at x = 0, light beyond.
class PenumbraWidth : public SoftShadowsTest {
 protected:
  /// Metres on the floor from a tenth of the light to nine tenths.
  double widthBehind(const RayCaster& caster, const SyntheticLight& light,
                     const SoftShadowSettings& settings) {
    constexpr float kDegrees = 20.0f;
    const RayCaster floor = plane({0.0, 0.0, 1.0}, kFloor);
    const SyntheticGBuffer gbuffer(kSize, perspective(kSize, kDegrees), floor);
    const SyntheticShadow shadow(nearest({floor, caster}), light, kMapSize);
    Unfiltered<SoftShadows> unfiltered(settings);  // a level's filter is wider than narrow penumbras
    unfiltered.effect().setInputs(shadow.inputs());
    multiResolution_.settings().technique = Technique::full;
    const Image image{kSize, 1, renderPicture(multiResolution_, unfiltered, gbuffer.frame())};
    const std::vector<double> light0to1 = meansOfColumns(image);
    const double tangent = std::tan(glm::radians(0.5 * static_cast<double>(kDegrees)));
    return (placeOf(0.9, light0to1) - placeOf(0.1, light0to1)) * 2.0 * tangent * -kFloor / kSize.y;
  }

  static constexpr double kFloor = -6.0;  ///< z
  /// Light comes down at 1 to 2: across it, a length is shorter than on the floor by the cosine, 2 / sqrt(5).
  static constexpr double kAcrossLight = 0.894427190999916;
  /// Of a disk that an edge cuts, in radii: x sqrt(1 - x^2) + asin(x) is 0.4 pi at x = 0.687.
  static constexpr double kTenthToNineTenths = 2.0 * 0.687;
  static constexpr double kTolerance = 0.25;  ///< as a share
};

TEST_F(PenumbraWidth, OfASunIsThatOfItsAngle) {
  const SyntheticLight sun = parallelLight({-1.0, 0.0, 2.0}, {0.0, 0.0, kFloor}, 3.0f);
  const SoftShadowSettings soft{.filterRadius = 0.5f, .contactHardening = true, .lightAngle = 20.0f};
  const auto widthAt = [&](double height) {  // of the upper side, whose edge it is that the shadow ends with
    const RayCaster caster =
        box({-20.0, -20.0, kFloor + height - 0.1}, {-0.5 * height, 20.0, kFloor + height});
    return widthBehind(caster, sun, soft);
  };
  const auto geometric = [&](double height) {
    const double radius = std::tan(glm::radians(10.0)) * height / kAcrossLight;
    return kTenthToNineTenths * radius / kAcrossLight;
  };
  const double near = widthAt(0.4);
  const double far = widthAt(2.1);
  EXPECT_NEAR(near, geometric(0.4), kTolerance * geometric(0.4));
  EXPECT_NEAR(far, geometric(2.1), kTolerance * geometric(2.1));
  EXPECT_NEAR(far / near, 2.1 / 0.4, kTolerance * 2.1 / 0.4);
}

TEST_F(PenumbraWidth, OfALampIsThatOfItsSize) {
  // Two metres over the floor, and the caster is half way: the penumbra is as large as the light.
  const SyntheticLight lamp = spotLight({-1.0, 0.0, kFloor + 2.0}, {-1.0, 0.0, kFloor});
  const RayCaster caster = box({-20.0, -20.0, kFloor + 0.98}, {-0.5, 20.0, kFloor + 1.0});
  for (const float radius : {0.1f, 0.3f}) {
    const double width =
        widthBehind(caster, lamp, {.filterRadius = 1.0f, .contactHardening = true, .lightRadius = radius});
    const double geometric = kTenthToNineTenths * static_cast<double>(radius) / kAcrossLight;
    EXPECT_NEAR(width, geometric, kTolerance * geometric) << radius;
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
