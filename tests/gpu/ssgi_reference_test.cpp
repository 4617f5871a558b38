// SSGI's shade() on the GPU against an independent double-precision implementation.
#include "tests/support/ssgi_reference.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

/// Each pixel another colour, some of them brighter than any limit or less than black.
LitPicture randomPicture(glm::ivec2 size) {
  auto generator = std::mt19937(3);
  std::uniform_real_distribution<float> random(-0.5f, 3.0f);
  return {size,
          [&](glm::ivec2) { return glm::vec3(random(generator), random(generator), random(generator)); }};
}

class SsgiReferenceTest : public GlTest {
 protected:
  /// Compares some hundreds of pixels. A few samples of a pixel may fall to the other side of a decision
  /// (which pixel, which mip, in front or behind) by rounding: at most three, and in few pixels.
  void expectLikeReference(const SyntheticGBuffer& gbuffer, const SsgiSettings& settings) {
    const LitPicture lit = randomPicture(gbuffer.frame().size);
    const SsgiInputs inputs{.radiance = lit.texture.id(),
                            .radianceScale = 1.5f,
                            .environmentAbove = {0.5f, 1.0f, 2.0f},
                            .environmentBelow = {0.75f, 0.25f, 0.0f},
                            .up = glm::normalize(glm::vec3(0.3f, 0.9f, -0.2f))};
    Unfiltered<Ssgi> effect(settings);
    effect.effect().setInputs(inputs);
    MultiResolution multiResolution;
    multiResolution.settings().technique = Technique::full;
    const Image image{gbuffer.frame().size, 3, renderPicture(multiResolution, effect, gbuffer.frame())};
    compare(image, SsgiReference(gbuffer, lit, settings, inputs), settings);
  }

 private:
  static void compare(const Image& image, const SsgiReference& reference, const SsgiSettings& settings) {
    const double sample =
        std::max(2.0, static_cast<double>(settings.maxRadiance * settings.intensity)) / settings.samples;
    int compared = 0;
    int flipped = 0;
    double sum = 0.0;
    for (int i = 5; i < image.size.x * image.size.y; i += 29) {
      const glm::ivec2 pixel(i % image.size.x, i / image.size.x);
      const glm::dvec3 expected = reference.arriving(pixel);
      for (int channel = 0; channel < 3; ++channel) {
        const double difference = std::abs(expected[channel] - static_cast<double>(image.at(pixel, channel)));
        const double rounding = std::max(expected[channel], 0.25) / 1024.0;  // of halves, towards zero
        ASSERT_LE(difference, 3.01 * sample + rounding) << pixel.x << ", " << pixel.y;
        ++compared;
        flipped += difference > rounding ? 1 : 0;
        sum += difference;
      }
    }
    EXPECT_GT(compared, 900);
    EXPECT_LT(flipped, compared / 10);
    EXPECT_LT(sum / compared, 0.05 * sample + 5e-4);
  }
};

TEST_F(SsgiReferenceTest, OfARoom) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  expectLikeReference(gbuffer, {.samples = 16});
  expectLikeReference(gbuffer, {.radius = 0.5f, .samples = 64, .seed = 7});
  expectLikeReference(gbuffer,
                      {.radius = 3.0f, .samples = 32, .intensity = 1.5f, .bias = 0.05f, .maxRadiance = 2.0f});
}

TEST_F(SsgiReferenceTest, OfASphereOnAPlaneBeforeTheSky) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size, 40.0f),
                                 nearest({plane({0.0, 1.0, 0.1}, -1.0), sphere({0.2, -0.4, -4.0}, 0.7)}));
  expectLikeReference(gbuffer, {.samples = 32});
}

TEST_F(SsgiReferenceTest, OfAnOrthographicView) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer orthographic(size, glm::ortho(-3.0f, 3.0f, -1.4f, 2.0f, 0.1f, 20.0f), room());
  expectLikeReference(orthographic, {.radius = 0.6f, .samples = 24});
}

// The uniform block holds 1024 points.
TEST_F(SsgiReferenceTest, OfMorePointsThanAUniformBlockHolds) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const int samples : {1024, 1025, 1200}) expectLikeReference(gbuffer, {.samples = samples});
}

}  // namespace
}  // namespace mres::test
