// The filter of soft shadows and the radius of their penumbras against double precision.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/gtc/matrix_access.hpp>
#include <gtest/gtest.h>
#include <random>
#include <utility>
#include <vector>

#include "effects/soft_shadows/disk_samples.h"
#include "effects/soft_shadows/soft_shadows.h"
#include "mres/mres.h"
#include "shaders/effects/soft_shadows_params.h"
#include "tests/gpu/soft_shadows_support.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/synthetic_shadow.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

/// A surface of a pixel, in view space, and how far the pixel turns its samples.
struct Receiver {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};
  double azimuth = 0.0;
};

Receiver receiverAt(const SyntheticGBuffer& gbuffer, glm::ivec2 pixel) {
  constexpr int kBayer[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  const glm::ivec2 size = gbuffer.frame().size;
  const auto index = static_cast<std::size_t>(pixel.y * size.x + pixel.x);
  const glm::dvec2 ndc = (glm::dvec2(pixel) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
  const double depth = static_cast<double>(gbuffer.depths()[index]) * 2.0 - 1.0;
  const glm::dmat4 viewFromClip = glm::inverse(glm::dmat4(gbuffer.frame().projection));
  const glm::dvec4 point = viewFromClip * glm::dvec4(ndc, depth, 1.0);
  return {.position = glm::dvec3(point) / point.w,
          .normal = glm::dvec3(gbuffer.normals()[index]),
          .azimuth = kBayer[(pixel.y & 3) * 4 + (pixel.x & 3)] * glm::radians(22.5)};
}

/// Percentage-closer filtering and percentage-closer soft shadows written anew: the light ray through a
/// texel's centre meets the receiver's plane, raised by the bias, and what the map shows.
class SoftShadowReference {
 public:
  SoftShadowReference(const SyntheticShadow& shadow, const SoftShadowSettings& settings)
      : shadow_(shadow),
        settings_(settings),
        mapFromView_(shadow.inputs().shadowFromView),
        viewFromMap_(glm::inverse(mapFromView_)),
        samples_(diskSamples(settings.samples, settings.seed)),
        blockerSamples_(diskSamplesToTheRim(SOFT_SHADOWS_BLOCKER_SAMPLES, settings.seed)) {}

  /// Whether the map covers a receiver, and light falls on it so steeply that the disk keeps its size.
  [[nodiscard]] bool covers(const Receiver& receiver) const {
    const glm::dvec3 window = windowOf(receiver.position);
    const glm::dvec3 light(shadow_.inputs().light);
    const glm::dvec3 toLight = isParallel() ? light : light - receiver.position;
    return glm::all(glm::greaterThan(window, glm::dvec3(0.0))) &&
           glm::all(glm::lessThan(window, glm::dvec3(1.0))) &&
           glm::dot(receiver.normal, glm::normalize(toLight)) >= 0.35;
  }

  [[nodiscard]] double visibility(const Receiver& receiver) const {
    const double radius = settings_.contactHardening ? penumbraRadius(receiver) : largestRadius();
    const std::vector<LightRay> rays = lightRays(receiver, samples_, radius);
    const auto lit = std::ranges::count(rays, false, &LightRay::isBlocked);
    return static_cast<double>(lit) / settings_.samples;
  }

  /// Half of what one sample makes.
  [[nodiscard]] double tolerance() const { return 0.5 / settings_.samples; }

 private:
  struct LightRay {
    glm::dvec3 onPlane;  ///< where it meets the receiver's plane
    glm::dvec3 onMap;    ///< where it meets what the map shows
    bool isBlocked;
  };

  [[nodiscard]] bool isParallel() const { return shadow_.inputs().light.w == 0.0f; }
  [[nodiscard]] double largestRadius() const { return static_cast<double>(settings_.filterRadius); }
  [[nodiscard]] glm::dvec2 mapSize() const { return glm::dvec2(shadow_.inputs().mapSize); }

  [[nodiscard]] glm::dvec3 windowOf(glm::dvec3 position) const {
    const glm::dvec4 clip = mapFromView_ * glm::dvec4(position, 1.0);
    return glm::dvec3(clip) / clip.w;
  }

  [[nodiscard]] glm::dvec3 positionOf(glm::dvec3 window) const {
    const glm::dvec4 point = viewFromMap_ * glm::dvec4(window, 1.0);
    return glm::dvec3(point) / point.w;
  }

  /// By how many texels a metre of movement can change the column and the row.
  [[nodiscard]] glm::dvec2 texelsPerMetre(glm::dvec3 position) const {
    constexpr double kStep = 1e-4;
    glm::dvec2 squares(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = kStep;
      const glm::dvec2 change(windowOf(position + step) - windowOf(position - step));
      squares += change * change;
    }
    return glm::sqrt(squares) * mapSize() / (2.0 * kStep);
  }

  /// Of a spot light, along its axis.
  [[nodiscard]] double distanceFromLight(glm::dvec3 position) const {
    const glm::dvec3 axis(glm::row(mapFromView_, 3));
    return glm::dot(position - glm::dvec3(shadow_.inputs().light), glm::normalize(axis));
  }

  /// It is blocked by what lies more than `rise` metres above the receiver's plane.
  [[nodiscard]] LightRay lightRay(glm::ivec2 texel, const Receiver& receiver, double rise) const {
    const glm::dvec2 place = (glm::dvec2(texel) + 0.5) / mapSize();
    const glm::dvec3 near = positionOf(glm::dvec3(place, 0.0));
    const glm::dvec3 far = positionOf(glm::dvec3(place, 1.0));
    const auto onPlaneThrough = [&](glm::dvec3 point) {
      return glm::mix(near, far,
                      glm::dot(point - near, receiver.normal) / glm::dot(far - near, receiver.normal));
    };
    const glm::dvec3 onRaised = onPlaneThrough(receiver.position + rise * receiver.normal);
    const double depth = shadow_.depth(texel);
    // Where the map shows nothing its depth is 1, which blocks nothing.
    return {onPlaneThrough(receiver.position), positionOf(glm::dvec3(place, depth)),
            depth < std::min(windowOf(onRaised).z, 1.0)};
  }

  /// Those of a disk of samples around a receiver; `radius` in metres across the light, no less than a texel.
  [[nodiscard]] std::vector<LightRay> lightRays(const Receiver& receiver,
                                                const std::vector<glm::vec2>& unitDisk, double radius) const {
    const glm::dvec2 perMetre = texelsPerMetre(receiver.position);
    const glm::dvec2 reach = glm::max(radius * perMetre, glm::dvec2(1.0));
    const double rise = static_cast<double>(settings_.bias) * reach.x / perMetre.x;
    const glm::dvec2 centre = glm::dvec2(windowOf(receiver.position)) * mapSize();
    const double c = std::cos(receiver.azimuth);
    const double s = std::sin(receiver.azimuth);
    const glm::dmat2 turn(c, s, -s, c);
    std::vector<LightRay> rays;
    for (const glm::vec2 sample : unitDisk) {
      const glm::ivec2 texel(glm::floor(centre + reach * (turn * glm::dvec2(sample))));
      rays.push_back(
          lightRay(glm::clamp(texel, glm::ivec2(0), shadow_.inputs().mapSize - 1), receiver, rise));
    }
    return rays;
  }

  /// In metres: by similar triangles, from the mean distance of what blocks.
  [[nodiscard]] double penumbraRadius(const Receiver& receiver) const {
    double sum = 0.0;
    int count = 0;
    for (const LightRay& ray : lightRays(receiver, blockerSamples_, largestRadius())) {
      if (!ray.isBlocked) continue;
      sum += isParallel() ? glm::distance(ray.onMap, ray.onPlane) : distanceFromLight(ray.onMap);
      ++count;
    }
    if (count == 0) return 0.0;
    const double mean = sum / count;
    const double slope = std::tan(glm::radians(0.5 * static_cast<double>(settings_.lightAngle)));
    const double behind = std::max(distanceFromLight(receiver.position) - mean, 0.0);
    const double radius =
        isParallel() ? mean * slope : static_cast<double>(settings_.lightRadius) * behind / mean;
    return std::min(radius, largestRadius());
  }

  const SyntheticShadow& shadow_;
  SoftShadowSettings settings_;
  glm::dmat4 mapFromView_;
  glm::dmat4 viewFromMap_;
  std::vector<glm::vec2> samples_;
  std::vector<glm::vec2> blockerSamples_;
};

/// How many pixels were compared, were in a penumbra, and had another value than the reference.
struct Agreement {
  int compared = 0;
  int partly = 0;
  int different = 0;
};

Agreement compare(const Image& image, const SyntheticGBuffer& gbuffer, const SoftShadowReference& reference) {
  Agreement agreement;
  for (int i = 0; i < image.size.x * image.size.y; ++i) {
    const glm::ivec2 pixel(i % image.size.x, i / image.size.x);
    const Receiver receiver = receiverAt(gbuffer, pixel);
    if (!reference.covers(receiver)) continue;
    const double expected = reference.visibility(receiver);
    const double difference = std::abs(static_cast<double>(image.at(pixel)) - expected);
    ++agreement.compared;
    agreement.partly += expected > 0.0 && expected < 1.0 ? 1 : 0;
    agreement.different += difference > reference.tolerance() ? 1 : 0;
  }
  return agreement;
}

class SoftShadowsReferenceTest : public SoftShadowsTest {
 protected:
  /// At full resolution, as the shader leaves it.
  Image renderUnfiltered(const SyntheticGBuffer& gbuffer, const SyntheticShadow& shadow,
                         const SoftShadowSettings& settings) {
    Unfiltered<SoftShadows> unfiltered(settings);
    unfiltered.effect().setInputs(shadow.inputs());
    multiResolution_.settings().technique = Technique::full;
    return {kSize, 1, renderPicture(multiResolution_, unfiltered, gbuffer.frame())};
  }
};

TEST_F(SoftShadowsReferenceTest, TheFilterAgreesWithDoublePrecision) {
  // A wall with boxes before it, lit well within the slopes for which the disk keeps its size.
  const RayCaster scene = nearest({plane({0.2, 0.1, 1.0}, -6.0), box({-1.5, -1.0, -5.5}, {-0.7, 0.6, -4.0}),
                                   box({0.2, -0.5, -5.0}, {0.9, 1.1, -4.5}), sphere({1.4, -1.0, -4.6}, 0.4)});
  const SyntheticLight sun = parallelLight({0.7, 0.5, 1.0}, {0.0, 0.0, -5.5}, 6.0f);
  const SoftShadowSettings settings{.samples = 31, .filterRadius = 0.15f, .seed = 3};
  const SyntheticShadow shadow(scene, sun, kMapSize);
  const SyntheticGBuffer gbuffer(kSize, perspective(kSize), scene);
  const Agreement agreement =
      compare(renderUnfiltered(gbuffer, shadow, settings), gbuffer, {shadow, settings});
  EXPECT_GT(agreement.compared, 4000);
  EXPECT_GT(agreement.partly, 300) << "there are penumbras";
  EXPECT_LE(agreement.different, agreement.compared / 50)
      << "samples on the border of two texels may fall either way";
}

double between(double low, double high, std::mt19937& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Boxes and spheres before a wall.
RayCaster randomThings(std::mt19937& random) {
  std::vector<RayCaster> things{plane({0.2, 0.1, 1.0}, -6.0)};
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 centre{between(-2.0, 2.0, random), between(-1.4, 1.4, random),
                            between(-5.0, -3.8, random)};
    const double half = between(0.2, 0.5, random);
    things.push_back(i % 2 == 0 ? box(centre - half, centre + half) : sphere(centre, half));
  }
  return nearest(std::move(things));
}

SyntheticLight randomSun(std::mt19937& random) {
  const glm::dvec3 toLight{between(-0.8, 0.8, random), between(-0.6, 0.6, random), 1.0};
  return parallelLight(toLight, {0.0, 0.0, -5.5}, 6.0f);
}

SyntheticLight randomLamp(std::mt19937& random) {
  const glm::dvec3 position{between(-1.2, 1.2, random), between(-1.0, 1.0, random),
                            between(-1.5, -0.5, random)};
  return spotLight(position, {0.0, 0.0, -6.0});
}

SoftShadowSettings settingsOf(bool pcss, int seed) {
  return {.samples = 64,
          .filterRadius = pcss ? 0.5f : 0.3f,
          .contactHardening = pcss,
          .lightAngle = 16.0f,
          .lightRadius = 0.3f,
          .seed = seed};
}

TEST_F(SoftShadowsReferenceTest, PenumbrasOfSunsAndLampsAgreeWithDoublePrecision) {
  std::mt19937 random(1);
  for (int i = 0; i < 4; ++i) {
    const RayCaster scene = randomThings(random);
    const SyntheticShadow shadow(scene, i % 2 == 0 ? randomSun(random) : randomLamp(random), kMapSize);
    const SyntheticGBuffer gbuffer(kSize, perspective(kSize), scene);
    for (const bool pcss : {false, true}) {
      SCOPED_TRACE(testing::Message() << "scene " << i << ", PCSS " << pcss);
      const SoftShadowSettings settings = settingsOf(pcss, i);
      const Image image = renderUnfiltered(gbuffer, shadow, settings);
      const Agreement agreement = compare(image, gbuffer, {shadow, settings});
      EXPECT_GT(agreement.compared, 3000);
      EXPECT_GT(agreement.partly, 300);
      EXPECT_LE(agreement.different, agreement.partly / 10);
      if (!pcss) continue;
      SoftShadowSettings larger = settings;
      larger.lightAngle *= 1.15f;
      larger.lightRadius *= 1.15f;
      EXPECT_GT(compare(image, gbuffer, {shadow, larger}).different, agreement.partly / 2)
          << "penumbras that are wrong by 15 % would be found";
    }
  }
}

}  // namespace
}  // namespace mres::test
