#pragma once

#include <glm/glm.hpp>

#include "mres/gl/full_screen.h"
#include "mres/gl/object.h"
#include "mres/gl/program.h"
#include "mres/gl/texture.h"

namespace mres {

/// What the surfaces of a frame send, for SSGI: the lit picture at half the resolution and its mips
/// (RGBA16F), so that points far from a pixel meet means over many pixels, and few cache lines.
class SenderPyramid {
 public:
  /// `unit` is where the lit picture is read and the pyramid bound, `paramsBinding` where SsgiParams is.
  /// Throws std::runtime_error if the driver rejects the shader. Needs a state guard, as all of this class
  /// does.
  SenderPyramid(GLuint unit, GLuint paramsBinding);

  /// Needs the lit picture and the block bound there, and depth, normals and the frame's block bound. Leaves
  /// the pyramid bound to the unit. Throws std::runtime_error if the driver rejects the target.
  void draw(glm::ivec2 fullSize);

  [[nodiscard]] std::size_t bytes() const { return texture_.bytes(); }

 private:
  struct Pass {
    Pass(bool fromPicture, GLuint unit, GLuint paramsBinding);
    gl::Program program;
    GLint level;
  };

  void resize(glm::ivec2 fullSize);
  void attach(int level) const;
  void drawLevel(const Pass& pass, int level) const;

  GLuint unit_;
  Pass fromPicture_;
  Pass fromLevel_;
  gl::FramebufferName framebuffer_ = gl::FramebufferName::create();
  gl::FullScreenTriangle triangle_;
  gl::SamplerName nearestMip_ = gl::makeSampler(gl::Filter::nearestMip);
  gl::Texture2D texture_;
  glm::ivec2 fullSize_{0};
};

}  // namespace mres
