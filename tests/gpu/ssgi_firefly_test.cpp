// What a highlight of a single pixel may do to SSGI: met by few points, it must not show as bright dots.
#include <algorithm>
#include <array>
#include <cstddef>

#include "tests/gpu/ssgi_support.h"
#include "tests/support/ssgi_reference.h"

namespace mres::test {
namespace {

constexpr float kDim = 0.2f;  // what all pixels but one send
constexpr float kHighlight = 1e4f;

/// Of the 5x5 pixels around.
float medianAround(const Image& image, glm::ivec2 centre) {
  constexpr int kReach = 2;
  constexpr int kSide = 2 * kReach + 1;
  std::array<float, kSide * kSide> values{};
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::ivec2 pixel = centre + glm::ivec2(i % kSide, i / kSide) - kReach;
    values.at(static_cast<std::size_t>(i)) = image.at(glm::clamp(pixel, glm::ivec2(0), image.size - 1));
  }
  std::ranges::nth_element(values, values.begin() + values.size() / 2);
  return values.at(values.size() / 2);
}

/// How far any pixel is above those around it.
float brightestDot(const Image& image) {
  float most = 0.0f;
  for (int i = 0; i < image.size.x * image.size.y; ++i) {
    const glm::ivec2 pixel(i % image.size.x, i / image.size.x);
    most = std::max(most, image.at(pixel) - medianAround(image, pixel));
  }
  return most;
}

/// How far any pixel is above that of another picture.
float largestGain(const Image& image, const Image& over) {
  float most = 0.0f;
  for (std::size_t i = 0; i < image.texels.size(); ++i)
    most = std::max(most, image.texels.at(i) - over.texels.at(i));
  return most;
}

/// A floor before a wall, and on the wall a highlight, so high above the floor that points which meet it read
/// mip 4 of depth or a coarser one. It lies in the very pixel that its texel of mip 4 has the depth of.
class Fireflies : public SsgiTest {
 protected:
  Image renderWith(float highlight, float maxRadiance, Technique technique) {
    const LitPicture lit(size_, [&](glm::ivec2 at) { return glm::vec3(at == place_ ? highlight : kDim); });
    return render(gbuffer_, {.radius = 2.0f, .samples = 64, .maxRadiance = maxRadiance},
                  {.radiance = lit.texture.id()}, technique);
  }

  const glm::ivec2 size_{480, 360};
  const glm::ivec2 place_ = pixelOf(perspective(size_), size_, {0.0, 0.5, -3.0}) / 16 * 16 + 8;
  const SyntheticGBuffer gbuffer_{size_, perspective(size_),
                                  nearest({plane({0.0, 1.0, 0.0}, -1.0), plane({0.0, 0.0, 1.0}, -3.0)})};
};

TEST_F(Fireflies, AreNoneByDefault) {
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    const Image image = renderWith(kHighlight, SsgiSettings{}.maxRadiance, technique);
    EXPECT_LT(brightestDot(image), 0.5f * kDim) << static_cast<int>(technique);
  }
}

// A point that meets the highlight's texel counts a 64th, and the filter takes the mean over 16 azimuths, at
// coarse levels over 4. So each adds the mean of 256 pixels / 1024, 0.004, or 0.015, and a few meet it. Were
// that one pixel sent instead, each would add 1.
TEST_F(Fireflies, AreNoneWhereAHighlightIsHardlyBounded) {
  constexpr float kMaxRadiance = 1000.0f;
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    const Image dim = renderWith(kDim, kMaxRadiance, technique);
    const Image image = renderWith(kHighlight, kMaxRadiance, technique);
    EXPECT_LT(brightestDot(image), 0.5f * kDim) << static_cast<int>(technique);
    EXPECT_LT(largestGain(image, dim), kDim) << static_cast<int>(technique);
    EXPECT_GT(largestGain(image, dim), 0.001f) << "it is not met by " << static_cast<int>(technique);
  }
}

}  // namespace
}  // namespace mres::test
