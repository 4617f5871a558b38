#include "host/renderer/read_texture.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace host {
namespace {

GLenum formatOf(GLuint texture, int channels) {
  glBindTexture(GL_TEXTURE_2D, texture);
  GLint depthBits = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &depthBits);
  if (depthBits > 0) return GL_DEPTH_COMPONENT;
  static constexpr std::array<GLenum, 5> kFormats = {0, GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return kFormats.at(static_cast<std::size_t>(channels));
}

}  // namespace

FloatImage readTexture(GLuint texture, glm::ivec2 size, int channels) {
  const GLenum format = formatOf(texture, channels);
  if (format == GL_DEPTH_COMPONENT && channels != 1) {
    throw std::invalid_argument("A depth texture has one channel to read.");
  }
  const auto rowLength = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(channels);
  FloatImage image{size, channels, std::vector<float>(rowLength * static_cast<std::size_t>(size.y))};
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (const GLenum skip : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
    glPixelStorei(skip, 0);
  glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, image.pixels.data());
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(size.y) - 1; top < bottom; ++top, --bottom) {
    const auto row = [&](std::size_t y) {
      return image.pixels.begin() + static_cast<std::ptrdiff_t>(y * rowLength);
    };
    std::swap_ranges(row(top), row(top + 1), row(bottom));
  }
  return image;
}

}  // namespace host
