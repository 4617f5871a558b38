#pragma once

#include "host/renderer/lighting/light_set.h"
#include "host/renderer/shadow/shadow_pass.h"
#include "shaders/host/environment_params.h"

namespace host {

/// Everything that shines on the scene, for every program that includes host/shading.glsl: the lights, the
/// shadow map of one of them, ambient light and sky.
class Illumination {
 public:
  Illumination(const Scene& scene, const mres::gl::ShaderLibrary& library, ShadowMapNeeds shadowMap);

  /// Brings the shadow map and the lights' positions up to date for a camera.
  void update(const GpuScene& scene, const Camera& camera, const CameraView& view, float aspect,
              mres::gl::Profiler& profiler);

  /// Points the blocks and samplers of a program at their places; needs the program in use.
  static void connect(const mres::gl::Program& program);
  /// Binds everything for programs that were connected.
  void bind() const;

  [[nodiscard]] const LightSet& lights() const { return lights_; }
  [[nodiscard]] const AmbientLight& ambient() const { return ambient_; }
  [[nodiscard]] const ShadowPass& shadow() const { return shadow_; }

 private:
  LightSet lights_;
  ShadowPass shadow_;
  AmbientLight ambient_;
  mres::gl::UniformBuffer<mres::params::EnvironmentParams> environment_;
  mres::gl::UniformBuffer<mres::params::LightParams> lightBlock_;
};

}  // namespace host
