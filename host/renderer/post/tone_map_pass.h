#pragma once

#include "mres/gl/full_screen.h"
#include "mres/gl/profiler.h"
#include "mres/gl/program.h"
#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "shaders/host/tone_map_params.h"

namespace host {

/// Turns radiance into what a screen shows.
class ToneMapPass {
 public:
  explicit ToneMapPass(const mres::gl::ShaderLibrary& library);

  void draw(const mres::gl::Texture2D& radiance, float exposure, mres::gl::Profiler& profiler);

  /// RGBA8, sRGB-encoded.
  [[nodiscard]] const mres::gl::Texture2D& picture() const { return target_.color(); }
  [[nodiscard]] std::size_t bytes() const { return target_.bytes(); }

 private:
  mres::gl::Program program_;
  mres::gl::RenderTarget target_;
  mres::gl::SamplerName nearest_;
  mres::gl::UniformBuffer<mres::params::ToneMapParams> params_;
  mres::gl::FullScreenTriangle triangle_;
};

}  // namespace host
