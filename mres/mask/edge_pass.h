#pragma once

#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/pass_context.h"
#include "mres/settings.h"
#include "shaders/mres/edges_params.h"
#include "shaders/mres/frame_params.h"

namespace mres {

/// The thresholds as the shaders have them.
params::EdgesParams edgesParams(const MaskSettings& settings, const params::FrameParams& frame);

/// Finds the geometry edges of a frame: red normals, green depth, at half resolution (section 3.1 of the
/// paper).
class EdgePass {
 public:
  explicit EdgePass(const gl::ShaderLibrary& library);

  /// Needs depth and normals bound to their units and the frame's block bound.
  void draw(PassContext& context, const MaskSettings& settings, const params::FrameParams& frame);

  /// GL_RG8, ceil(size / 2).
  [[nodiscard]] const gl::Texture2D& edges() const { return target_.color(); }
  void fill(float value) const { target_.fill(value); }
  [[nodiscard]] std::size_t bytes() const { return target_.bytes(); }

 private:
  gl::Program program_;
  gl::UniformBuffer<params::EdgesParams> params_;
  gl::RenderTarget target_;
};

}  // namespace mres
