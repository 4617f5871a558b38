// The filter of soft shadows against double precision.
#include <cmath>
#include <cstddef>
#include <glm/gtc/matrix_access.hpp>
#include <gtest/gtest.h>
#include <vector>

#include "effects/soft_shadows/disk_samples.h"
#include "effects/soft_shadows/soft_shadows.h"
#include "mres/mres.h"
#include "tests/gpu/soft_shadows_support.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/synthetic_shadow.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

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

}  // namespace
}  // namespace mres::test
