#include "host/truth/alpha_mask.h"

#include <algorithm>
#include <cmath>

namespace host {
namespace {

/// A texel's index inside of the image.
int wrapped(int texel, int size, Wrap wrap) {
  if (wrap == Wrap::clampToEdge) return std::clamp(texel, 0, size - 1);
  const int period = wrap == Wrap::mirroredRepeat ? 2 * size : size;
  const int inPeriod = (texel % period + period) % period;
  return inPeriod < size ? inPeriod : period - 1 - inPeriod;
}

template <class Item>
const Item* itemAt(const std::vector<Item>& items, int index) {
  return index >= 0 && index < static_cast<int>(items.size()) ? &items[static_cast<std::size_t>(index)]
                                                              : nullptr;
}

/// A place along an image, in texels, such that whole numbers around it are ints: beyond 2^23, floats have no
/// fraction left. What is no number, as products that overflow may leave, becomes the least.
float bounded(float texels) {
  constexpr float kLargest = 0x1p23f;
  return std::fmin(std::fmax(texels, -kLargest), kLargest);
}

}  // namespace

AlphaMask::AlphaMask(const Scene& scene, const Mesh& mesh)
    : mesh_(mesh),
      material_(scene.materials.at(static_cast<std::size_t>(mesh.material))),
      texture_(itemAt(scene.textures, material_.baseColorTexture.texture)),
      image_(texture_ ? itemAt(scene.images, texture_->image) : nullptr) {}

bool AlphaMask::isHole(unsigned triangle, float u, float v) const {
  const auto uvOf = [&](unsigned corner) { return mesh_.vertices[mesh_.indices[3 * triangle + corner]].uv; };
  return alphaAt((1.0f - u - v) * uvOf(0) + u * uvOf(1) + v * uvOf(2)) < material_.alphaCutoff;
}

/// Of the finest mip; interpolated, unless the texture says otherwise.
float AlphaMask::alphaAt(glm::vec2 uv) const {
  if (!image_ || image_->pixels.empty()) return material_.baseColor.a;
  const glm::vec2 moved(material_.baseColorTexture.uvTransform * glm::vec3(uv, 1.0f));
  const glm::vec2 place(bounded(moved.x * static_cast<float>(image_->size.x)),
                        bounded(moved.y * static_cast<float>(image_->size.y)));
  if (texture_->nearest) return material_.baseColor.a * texelAlpha(glm::floor(place));
  const glm::vec2 low = glm::floor(place - 0.5f);
  const glm::vec2 share = place - 0.5f - low;
  const glm::ivec2 first(low);
  const float bottom = glm::mix(texelAlpha(first), texelAlpha(first + glm::ivec2(1, 0)), share.x);
  const float top = glm::mix(texelAlpha(first + glm::ivec2(0, 1)), texelAlpha(first + 1), share.x);
  return material_.baseColor.a * glm::mix(bottom, top, share.y);
}

float AlphaMask::texelAlpha(glm::ivec2 texel) const {
  const int x = wrapped(texel.x, image_->size.x, texture_->wrapS);
  const int y = wrapped(texel.y, image_->size.y, texture_->wrapT);
  const std::size_t pixel = static_cast<std::size_t>(y) * image_->size.x + x;
  return static_cast<float>(image_->pixels[4 * pixel + 3]) / 255.0f;
}

}  // namespace host
