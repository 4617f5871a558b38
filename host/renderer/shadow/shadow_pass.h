#pragma once

#include <optional>

#include "host/renderer/scene/gpu_scene.h"
#include "host/renderer/screen_effects.h"
#include "host/renderer/shadow/shadow_fit.h"
#include "mres/gl/profiler.h"
#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "shaders/host/shadow_params.h"

namespace host {

/// Draws the shadow map of the light that casts shadows, and keeps it for as long as it stays the same.
class ShadowPass {
 public:
  /// Without such a light nothing is ever drawn and the map is one texel.
  ShadowPass(const mres::gl::ShaderLibrary& library, const std::optional<Light>& caster,
             ShadowMapNeeds needs);

  void draw(const GpuScene& scene, const Camera& camera, const CameraView& view, float aspect,
            mres::gl::Profiler& profiler);

  /// Points the block and the sampler of host/shadow_lookup.glsl at their places; needs the program in use.
  static void connect(const mres::gl::Program& program);
  /// Binds the shadow map for programs that were connected.
  void bind() const;

  /// Of the last draw(), for a view; no map where nothing was drawn.
  [[nodiscard]] ShadowMap shadow(const CameraView& view) const;
  [[nodiscard]] const mres::gl::Texture2D& map() const { return target_.depthStencil(); }

 private:
  [[nodiscard]] std::optional<ShadowView> viewOf(const Bounds& scene, const Camera& camera,
                                                 const CameraView& view, float aspect) const;
  void drawMap(const GpuScene& scene, glm::vec3 origin);
  void upload(const std::optional<ShadowView>& view, glm::vec3 origin);

  std::optional<Light> caster_;
  ShadowMapNeeds needs_;
  mres::gl::Program program_;
  mres::gl::RenderTarget target_;
  mres::gl::SamplerName comparing_;
  mres::gl::UniformBuffer<mres::params::ViewParams> view_;
  mres::gl::UniformBuffer<mres::params::ShadowParams> params_;
  std::optional<ShadowView> drawn_;  // what the map holds
  bool isSeen_ = false;              // whether the last view sees anything that the light may reach
};

}  // namespace host
