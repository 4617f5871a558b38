#include "mres/gl/bound_texture.h"

#include <array>
#include <stdexcept>
#include <string>

namespace mres::gl {
namespace {

std::string inWords(glm::ivec2 size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y);
}

/// Names of other targets cannot be told from those of GL_TEXTURE_2D but by the error of binding them.
bool bindsAsTexture2D(GLuint unit, GLuint texture, const SamplerName& sampler) {
  if (glIsTexture(texture) == GL_FALSE) return false;  // binding a name without a texture would make one
  bindTexture(unit, 0, sampler);
  bindTexture(unit, texture, sampler);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  if (static_cast<GLuint>(bound) == texture) return true;
  static_cast<void>(glGetError());
  return false;
}

bool isInteger(GLint type) {
  return type == GL_INT || type == GL_UNSIGNED_INT;
}

struct Channel {
  GLenum size;
  GLenum type;
};

constexpr std::array<Channel, 3> kChannels{{{GL_TEXTURE_RED_SIZE, GL_TEXTURE_RED_TYPE},
                                            {GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_GREEN_TYPE},
                                            {GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_BLUE_TYPE}}};

}  // namespace

BoundTexture::BoundTexture(const char* name, GLuint unit, GLuint texture, const SamplerName& sampler)
    : name_(name) {
  if (!bindsAsTexture2D(unit, texture, sampler))
    refuse("must name a GL_TEXTURE_2D; " + std::to_string(texture) + " is none.");
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, &level_);
}

void BoundTexture::refuse(const std::string& reason) const {
  throw std::invalid_argument(std::string(name_) + " " + reason);
}

GLint BoundTexture::parameter(GLenum parameter) const {
  GLint value = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, level_, parameter, &value);
  return value;
}

void BoundTexture::requireSize(glm::ivec2 size, const char* what) const {
  const glm::ivec2 actual(parameter(GL_TEXTURE_WIDTH), parameter(GL_TEXTURE_HEIGHT));
  if (actual != size) refuse("has " + inWords(actual) + " texels, but " + what + " " + inWords(size) + ".");
}

void BoundTexture::requireChannels(int count) const {
  const Channel& last = kChannels.at(static_cast<std::size_t>(count - 1));
  if (parameter(last.size) == 0 || isInteger(parameter(last.type)))
    refuse("must have at least " + std::to_string(count) + (count == 1 ? " channel" : " channels") +
           " of a format that is not an integer one.");
}

void BoundTexture::requireDepth() const {
  if (parameter(GL_TEXTURE_DEPTH_SIZE) == 0) refuse("must have a depth format; it has a colour format.");
}

}  // namespace mres::gl
