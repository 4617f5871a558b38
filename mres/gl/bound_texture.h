#pragma once

#include <glm/glm.hpp>
#include <string>

#include "mres/gl/texture.h"

namespace mres::gl {

/// A texture of the host's, bound for a frame and checked in every frame: a host may give a name to another
/// texture, and the state guard waits for the driver's answers anyway. What is refused is told by
/// std::invalid_argument with a sentence that begins with `name`, e.g. "Frame::depth", and leaves no OpenGL
/// error behind.
class BoundTexture {
 public:
  /// Refuses what is no GL_TEXTURE_2D.
  BoundTexture(const char* name, GLuint unit, GLuint texture, const SamplerName& sampler);

  /// `what` is where the host said so, in words: "Frame::size is".
  void requireSize(glm::ivec2 size, const char* what) const;
  /// So many channels at least, that shaders read as floats.
  void requireChannels(int count) const;
  void requireDepth() const;

  /// Of the level that shaders see as level 0.
  [[nodiscard]] GLint parameter(GLenum parameter) const;

 private:
  [[noreturn]] void refuse(const std::string& reason) const;

  const char* name_;
  GLint level_ = 0;
};

}  // namespace mres::gl
