#include "mres/level/frame_textures.h"

#include <stdexcept>
#include <string>

namespace mres {
namespace {

[[noreturn]] void refuse(const char* member, const std::string& reason) {
  throw std::invalid_argument(std::string("Frame::") + member + " " + reason);
}

std::string inWords(glm::ivec2 size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y);
}

/// Parameters of the level that shaders see as level 0. They are asked for in every frame: a host may give a
/// name to another texture, and the state guard waits for the driver's answers anyway.
class BoundTexture {
 public:
  BoundTexture() { glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, &level_); }
  [[nodiscard]] GLint parameter(GLenum name) const {
    GLint value = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, level_, name, &value);
    return value;
  }
  [[nodiscard]] glm::ivec2 size() const {
    return {parameter(GL_TEXTURE_WIDTH), parameter(GL_TEXTURE_HEIGHT)};
  }

 private:
  GLint level_ = 0;
};

/// Names of other targets cannot be told from those of GL_TEXTURE_2D but by the error of binding them.
bool bindsAsTexture2D(GLuint unit, GLuint texture, const gl::SamplerName& sampler) {
  if (glIsTexture(texture) == GL_FALSE) return false;  // binding a name without a texture would make one
  gl::bindTexture(unit, 0, sampler);
  gl::bindTexture(unit, texture, sampler);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  if (static_cast<GLuint>(bound) == texture) return true;
  static_cast<void>(glGetError());
  return false;
}

BoundTexture bindChecked(const char* member, GLuint unit, GLuint texture, const gl::SamplerName& sampler) {
  if (!bindsAsTexture2D(unit, texture, sampler)) {
    refuse(member, "must name a GL_TEXTURE_2D; " + std::to_string(texture) + " is none.");
  }
  return {};
}

BoundTexture bindChecked(const char* member, GLuint unit, GLuint texture, const gl::SamplerName& sampler,
                         glm::ivec2 size) {
  const BoundTexture bound = bindChecked(member, unit, texture, sampler);
  if (bound.size() != size) {
    refuse(member,
           "has " + inWords(bound.size()) + " texels, but Frame::size is " + inWords(size) + " pixels.");
  }
  return bound;
}

bool isInteger(GLint type) {
  return type == GL_INT || type == GL_UNSIGNED_INT;
}

// The pass that reads it binds it anew: its unit is that of other textures, too.
void checkImportance(const PassContext& context, GLuint texture) {
  const BoundTexture importance = bindChecked("importance", kMaskUnit, texture, context.linear);
  if (importance.parameter(GL_TEXTURE_RED_SIZE) == 0 ||
      isInteger(importance.parameter(GL_TEXTURE_RED_TYPE))) {
    refuse("importance", "must have a red channel of a format that is not an integer one.");
  }
}

}  // namespace

DepthFormat bindFrameTextures(const PassContext& context, const Frame& frame) {
  if (frame.importance != 0) checkImportance(context, frame.importance);
  const BoundTexture normals =
      bindChecked("normals", kNormalUnit, frame.normals, context.nearest, frame.size);
  if (normals.parameter(GL_TEXTURE_BLUE_SIZE) == 0 || isInteger(normals.parameter(GL_TEXTURE_BLUE_TYPE))) {
    refuse("normals", "must have three or four channels of a format that is not an integer one.");
  }
  const BoundTexture depth = bindChecked("depth", kDepthUnit, frame.depth, context.nearest, frame.size);
  const DepthFormat format{.bits = depth.parameter(GL_TEXTURE_DEPTH_SIZE),
                           .floatingPoint = depth.parameter(GL_TEXTURE_DEPTH_TYPE) == GL_FLOAT};
  if (format.bits == 0) refuse("depth", "must have a depth format; it has a colour format.");
  return format;
}

}  // namespace mres
