#pragma once

#include <array>

#include "mres/frame.h"
#include "mres/gl/render_target.h"
#include "mres/level/pass_context.h"
#include "mres/settings.h"

namespace mres {

/// Combines an edge image with the host's importance mask, by maximum or minimum (section 3.1 of the paper).
class ImportancePass {
 public:
  explicit ImportancePass(const gl::ShaderLibrary& library);

  /// Samples the frame's importance bilinearly over the screen. `edges` has the resolution of the mask of
  /// `level`. Returns both in one, GL_RG8: red edges of normals, green steps of depth and importance.
  const gl::Texture2D& draw(PassContext& context, MaskCombination combination, int level,
                            const gl::Texture2D& edges, const Frame& frame);

  void fill(float value) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  gl::Program maximum_;
  gl::Program minimum_;
  std::array<gl::RenderTarget, kMaxLevels - 1> targets_;
};

}  // namespace mres
