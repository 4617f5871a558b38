#pragma once

#include "host/renderer/gbuffer_textures.h"
#include "host/renderer/lighting/illumination.h"
#include "host/renderer/screen_effects.h"
#include "mres/gl/full_screen.h"
#include "mres/gl/profiler.h"
#include "mres/gl/render_target.h"

namespace host {

/// What the effects add, and the scene's exposure, which their radiances were multiplied by.
struct LightingInputs {
  ScreenEffects effects;
  float exposure = 1.0f;
};

/// Lights the G-buffer in one full-screen pass.
class LightingPass {
 public:
  explicit LightingPass(const mres::gl::ShaderLibrary& library);

  /// Expects view and illumination to be bound, and an accessibility.
  void draw(const GBufferTextures& gbuffer, const LightingInputs& inputs, glm::ivec2 size,
            mres::gl::Profiler& profiler);

  /// RGBA16F, linear radiance.
  [[nodiscard]] const mres::gl::Texture2D& radiance() const { return target_.color(); }
  [[nodiscard]] std::size_t bytes() const { return target_.bytes(); }

 private:
  mres::gl::Program program_;
  GLint hasVisibility_;
  GLint hasIndirect_;
  GLint indirectScale_;
  mres::gl::RenderTarget target_;
  mres::gl::SamplerName nearest_;
  mres::gl::FullScreenTriangle triangle_;
};

}  // namespace host
