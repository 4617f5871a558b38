#pragma once

#include <optional>

#include "host/renderer/scene/gpu_scene.h"
#include "host/renderer/screen_effects.h"
#include "host/renderer/shadow/shadow_fit.h"
#include "mres/gl/profiler.h"
#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "shaders/host/sun_params.h"

namespace host {

/// Draws the sun's shadow map, and keeps it for as long as it stays the same.
class ShadowPass {
 public:
  /// Without a sun nothing is ever drawn and the map is one texel.
  ShadowPass(const mres::gl::ShaderLibrary& library, const std::optional<Light>& sun, int mapSize);

  void draw(const GpuScene& scene, const Camera& camera, const CameraView& view, float aspect,
            mres::gl::Profiler& profiler);

  /// Points the block and the sampler of host/sun_shadow.glsl at their places; needs the program in use.
  static void connect(const mres::gl::Program& program);
  /// Binds sun and shadow map for programs that were connected.
  void bind() const;

  /// Of the last draw(), for a view; no map where nothing was drawn.
  [[nodiscard]] SunShadow shadow(const CameraView& view) const;
  [[nodiscard]] const mres::gl::Texture2D& map() const { return target_.depthStencil(); }

 private:
  void drawMap(const GpuScene& scene, glm::vec3 origin);
  void uploadSun(const std::optional<ShadowFit>& fit, glm::vec3 origin);

  std::optional<Light> sun_;
  mres::gl::Program program_;
  mres::gl::RenderTarget target_;
  mres::gl::SamplerName comparing_;
  mres::gl::UniformBuffer<mres::params::ViewParams> view_;
  mres::gl::UniformBuffer<mres::params::SunParams> params_;
  std::optional<ShadowFit> drawn_;  // what the map holds
  bool isSeen_ = false;             // whether the last view sees anything that the sun may light
};

}  // namespace host
