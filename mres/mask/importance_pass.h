#pragma once

#include "mres/gl/render_target.h"
#include "mres/level/pass_context.h"
#include "mres/settings.h"

namespace mres {

/// Combines an edge image with the host's importance mask, by maximum or minimum (section 3.1 of the paper).
class ImportancePass {
 public:
  explicit ImportancePass(const gl::ShaderLibrary& library);

  /// Samples `importance` bilinearly over a screen of `fullSize` pixels; texels of `edges` are two pixels
  /// wide.
  void draw(PassContext& context, MaskCombination combination, const gl::Texture2D& edges, GLuint importance,
            glm::ivec2 fullSize);

  /// GL_R8, of the size of the edge image.
  [[nodiscard]] const gl::Texture2D& edges() const { return target_.color(); }
  void fill(float value) const { target_.fill(value); }
  [[nodiscard]] std::size_t bytes() const { return target_.bytes(); }

 private:
  gl::Program maximum_;
  gl::Program minimum_;
  gl::RenderTarget target_;
};

}  // namespace mres
