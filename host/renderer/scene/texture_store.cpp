#include "host/renderer/scene/texture_store.h"

#include <array>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

namespace host {
namespace {

/// Below the least GL_MAX_LABEL_LENGTH, 256.
constexpr std::size_t kLongestLabel = 200;

GLint wrapMode(Wrap wrap) {
  switch (wrap) {
    case Wrap::mirroredRepeat:
      return GL_MIRRORED_REPEAT;
    case Wrap::clampToEdge:
      return GL_CLAMP_TO_EDGE;
    case Wrap::repeat:
      break;
  }
  return GL_REPEAT;
}

int mipLevels(glm::ivec2 size) {
  return std::bit_width(static_cast<unsigned>(glm::max(size.x, size.y)));
}

void checkSize(const Image& image) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (image.size.x <= largest && image.size.y <= largest) return;
  throw std::runtime_error("Image '" + image.name + "' has " + std::to_string(image.size.x) + " x " +
                           std::to_string(image.size.y) + " pixels, more than the " +
                           std::to_string(largest) + " that this OpenGL device takes; scale it down.");
}

mres::gl::Texture2D upload(const Image& image, TextureStore::Content content) {
  checkSize(image);
  const GLenum format = content == TextureStore::Content::color ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  const std::string label = image.name.substr(0, kLongestLabel);
  mres::gl::Texture2D texture(format, image.size, label.c_str(), mipLevels(image.size), image.pixels.data());
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

}  // namespace

TextureStore::TextureStore() : nearest_(mres::gl::makeSampler(mres::gl::Filter::nearest)) {
  static constexpr std::array<std::uint8_t, 4> kWhite = {255, 255, 255, 255};
  white_ = mres::gl::Texture2D(GL_RGBA8, glm::ivec2(1), "host.white", 1, kWhite.data());
}

TextureStore::Binding TextureStore::binding(const Scene& scene, const TextureUse& use, Content content) {
  if (use.texture < 0) return {white_.id(), nearest_.id()};
  const Texture& texture = scene.textures.at(static_cast<std::size_t>(use.texture));
  if (texture.image < 0) return {white_.id(), nearest_.id()};
  return {textureOf(scene, texture.image, content), samplerOf(texture)};
}

GLuint TextureStore::textureOf(const Scene& scene, int image, Content content) {
  const auto [entry, isNew] = textures_.try_emplace({image, content});
  if (isNew) entry->second = upload(scene.images.at(static_cast<std::size_t>(image)), content);
  return entry->second.id();
}

GLuint TextureStore::samplerOf(const Texture& texture) {
  const auto [entry, isNew] = samplers_.try_emplace({texture.wrapS, texture.wrapT, texture.nearest});
  if (isNew) {
    entry->second = mres::gl::SamplerName::create();
    const GLuint sampler = entry->second.id();
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, wrapMode(texture.wrapS));
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, wrapMode(texture.wrapT));
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, texture.nearest ? GL_NEAREST : GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER,
                        texture.nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
  }
  return entry->second.id();
}

std::size_t TextureStore::bytes() const {
  return std::accumulate(textures_.begin(), textures_.end(), white_.bytes(),
                         [](std::size_t sum, const auto& entry) { return sum + entry.second.bytes(); });
}

}  // namespace host
