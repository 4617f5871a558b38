#pragma once

#include "host/renderer/gbuffer_textures.h"
#include "host/renderer/scene/gpu_scene.h"
#include "mres/gl/profiler.h"
#include "mres/gl/render_target.h"

namespace host {

/// Draws what is known of the nearest opaque surface of each pixel.
class GBufferPass {
 public:
  explicit GBufferPass(const mres::gl::ShaderLibrary& library);

  /// Expects the view's block to be bound at bindings::kView.
  void draw(const GpuScene& scene, const CameraView& view, glm::ivec2 size, mres::gl::Profiler& profiler);

  [[nodiscard]] const GBufferTextures& textures() const { return textures_; }
  [[nodiscard]] std::size_t bytes() const { return target_.bytes(); }

 private:
  void resize(glm::ivec2 size);
  void clear() const;

  mres::gl::Program program_;
  mres::gl::RenderTarget target_;
  GBufferTextures textures_;
};

}  // namespace host
