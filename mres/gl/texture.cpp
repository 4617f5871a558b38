#include "mres/gl/texture.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "mres/gl/label.h"

namespace mres::gl {
namespace {

struct KnownFormat {
  GLenum internalFormat;
  FormatInfo info;
};

constexpr std::array kFormats = {
    KnownFormat{GL_R8, {GL_RED, GL_UNSIGNED_BYTE, 1}},
    KnownFormat{GL_RG8, {GL_RG, GL_UNSIGNED_BYTE, 2}},
    KnownFormat{GL_RGBA8, {GL_RGBA, GL_UNSIGNED_BYTE, 4}},
    KnownFormat{GL_SRGB8_ALPHA8, {GL_RGBA, GL_UNSIGNED_BYTE, 4}},
    KnownFormat{GL_RGB10_A2, {GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 4}},
    KnownFormat{GL_R11F_G11F_B10F, {GL_RGB, GL_FLOAT, 4}},
    KnownFormat{GL_R16F, {GL_RED, GL_HALF_FLOAT, 2}},
    KnownFormat{GL_RG16F, {GL_RG, GL_HALF_FLOAT, 4}},
    KnownFormat{GL_RGBA16F, {GL_RGBA, GL_HALF_FLOAT, 8}},
    KnownFormat{GL_R32F, {GL_RED, GL_FLOAT, 4}},
    KnownFormat{GL_RG32F, {GL_RG, GL_FLOAT, 8}},
    KnownFormat{GL_RGBA32F, {GL_RGBA, GL_FLOAT, 16}},
    KnownFormat{GL_DEPTH_COMPONENT16, {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2}},
    KnownFormat{GL_DEPTH_COMPONENT24, {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4}},
    KnownFormat{GL_DEPTH_COMPONENT32F, {GL_DEPTH_COMPONENT, GL_FLOAT, 4}},
    KnownFormat{GL_DEPTH24_STENCIL8, {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4}},
};

/// How OpenGL reads our pixels: rows without padding. The host's way is put back at the end.
class TightPixels {
 public:
  TightPixels() {
    for (std::size_t i = 0; i < kParameters.size(); ++i) {
      glGetIntegerv(kParameters.at(i), &before_.at(i));
      glPixelStorei(kParameters.at(i), kParameters.at(i) == GL_UNPACK_ALIGNMENT ? 1 : 0);
    }
  }
  ~TightPixels() {
    for (std::size_t i = 0; i < kParameters.size(); ++i) glPixelStorei(kParameters.at(i), before_.at(i));
  }
  TightPixels(const TightPixels&) = delete;
  TightPixels& operator=(const TightPixels&) = delete;

 private:
  static constexpr std::array<GLenum, 5> kParameters = {GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
                                                        GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                                                        GL_UNPACK_SWAP_BYTES};
  std::array<GLint, kParameters.size()> before_{};
};

}  // namespace

FormatInfo formatInfo(GLenum internalFormat) {
  const auto* found = std::ranges::find(kFormats, internalFormat, &KnownFormat::internalFormat);
  if (found == kFormats.end()) {
    throw std::invalid_argument(
        "This texture format is not one that mres allocates; see mres/gl/texture.cpp.");
  }
  return found->info;
}

Texture2D::Texture2D(GLenum internalFormat, glm::ivec2 size, const char* label, int levels,
                     const void* pixels)
    : name_(TextureName::create()), internalFormat_(internalFormat), size_(size), levels_(levels) {
  const FormatInfo info = formatInfo(internalFormat);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, name_.id());
  const TightPixels tightPixels;
  for (int level = 0; level < levels; ++level) {
    const glm::ivec2 levelSize = glm::max(size >> level, glm::ivec2(1));
    glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(internalFormat), levelSize.x, levelSize.y, 0,
                 info.format, info.type, level == 0 ? pixels : nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
  setLabel(GL_TEXTURE, name_.id(), label);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
}

std::size_t Texture2D::bytes() const {
  std::size_t texels = 0;
  for (int level = 0; level < levels_; ++level) {
    const glm::ivec2 levelSize = glm::max(size_ >> level, glm::ivec2(1));
    texels += static_cast<std::size_t>(levelSize.x) * static_cast<std::size_t>(levelSize.y);
  }
  return levels_ == 0 ? 0 : texels * static_cast<std::size_t>(formatInfo(internalFormat_).bytesPerTexel);
}

SamplerName makeSampler(Filter filter) {
  SamplerName sampler = SamplerName::create();
  const GLint magnify = filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
  const GLint minify = filter == Filter::nearestMip ? GL_NEAREST_MIPMAP_NEAREST : magnify;
  glSamplerParameteri(sampler.id(), GL_TEXTURE_MIN_FILTER, minify);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_MAG_FILTER, magnify);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return sampler;
}

void bindTexture(GLuint unit, GLuint texture, const SamplerName& sampler) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindSampler(unit, sampler.id());
}

}  // namespace mres::gl
