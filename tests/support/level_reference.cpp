#include "tests/support/level_reference.h"

#include <cmath>

#include "tests/support/mask_bench.h"

namespace mres::test {
namespace {

/// Where a pixel of the full resolution lies among the pixels of a coarser level, at which that was
/// evaluated, along one axis: in texels, with centres at + 0.5.
double placeAlong(int pixel, int level, int texels, int fullSize) {
  const auto position = [&](int texel) {
    return representative(glm::ivec2(texel), level, glm::ivec2(fullSize)).x;
  };
  if (pixel < position(0) || texels == 1) return 0.0;  // before the first centre: clamped
  int left = 0;
  while (left + 2 < texels && position(left + 1) <= pixel) ++left;
  return left + 0.5 + static_cast<double>(pixel - position(left)) / (position(left + 1) - position(left));
}

}  // namespace

double valueAt(glm::ivec2 fullPixel, int level) {
  const glm::dvec2 pixel = glm::dvec2(fullPixel) + 0.5;
  return 0.5 + 0.4 * std::sin(pixel.x * 0.05 + (1 << level)) * std::cos(pixel.y * 0.07);
}

std::string valueInGlsl() {
  return "float value = 0.5 + 0.4 * sin(surface.pixel.x * 0.05 + float(levelStride)) * "
         "cos(surface.pixel.y * 0.07);";
}

TestEffect::Recipe valueIn(const LevelTable& levels) {
  return {.body = valueInGlsl() + "return vec4(value);", .levels = levels};
}

glm::ivec2 representative(glm::ivec2 pixel, int level, glm::ivec2 fullSize) {
  return glm::min(pixel * (1 << level) + (1 << level) / 2, fullSize - 1);
}

Image coarsestPicture(const PlannedLevel& level, glm::ivec2 fullSize) {
  Image picture{level.size, 1, {}};
  for (int i = 0; i < level.size.x * level.size.y; ++i) {
    const glm::ivec2 pixel(i % level.size.x, i / level.size.x);
    picture.texels.push_back(
        static_cast<float>(valueAt(representative(pixel, level.index, fullSize), level.index)));
  }
  return picture;
}

double interpolated(const Image& picture, glm::ivec2 fullPixel, int level, glm::ivec2 fullSize) {
  return bilinear(picture, {placeAlong(fullPixel.x, level, picture.size.x, fullSize.x),
                            placeAlong(fullPixel.y, level, picture.size.y, fullSize.y)});
}

}  // namespace mres::test
