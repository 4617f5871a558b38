#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "mres/gl/texture.h"
#include "mres/level/pass_context.h"

namespace mres {

/// Mips of the pyramid of a screen: at most six, none empty.
int depthPyramidLevels(glm::ivec2 fullSize);

/// View depth of the full resolution and its mips (GL_R32F), so that samples far from a pixel read few cache
/// lines.
class DepthPyramid {
 public:
  explicit DepthPyramid(const gl::ShaderLibrary& library);

  /// Needs depth bound to its unit and the frame's block bound. Returns false, and draws nothing, if it has
  /// that of this frame (Frame::id).
  bool draw(PassContext& context, const Frame& frame);

  /// Fills every mip with `value`.
  void fill(float value);

  [[nodiscard]] const gl::Texture2D& texture() const { return texture_; }
  [[nodiscard]] std::size_t bytes() const { return texture_.bytes(); }

 private:
  void resize(glm::ivec2 fullSize);

  gl::Program program_;
  GLint levelLocation_;
  gl::Texture2D texture_;
  std::uint64_t frame_ = 0;                        // that it is of
  std::vector<gl::FramebufferName> framebuffers_;  // one a mip
};

}  // namespace mres
