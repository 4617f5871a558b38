#pragma once

#include "host/renderer/lighting/illumination.h"
#include "mres/gl/profiler.h"

namespace host {

/// Draws alpha-blended surfaces over the lit picture, forward, from back to front.
class TransparentPass {
 public:
  explicit TransparentPass(const mres::gl::ShaderLibrary& library);

  /// Expects view and illumination to be bound. `depth` is tested, not written.
  void draw(const GpuScene& scene, const CameraView& view, const mres::gl::Texture2D& radiance, GLuint depth,
            mres::gl::Profiler& profiler);

 private:
  mres::gl::Program program_;
  mres::gl::FramebufferName framebuffer_;
};

}  // namespace host
