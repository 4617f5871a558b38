#include "host/renderer/lighting/illumination.h"

#include "host/renderer/bindings.h"
#include "host/renderer/lighting/environment.h"

namespace host {

Illumination::Illumination(const Scene& scene, const mres::gl::ShaderLibrary& library,
                           ShadowMapNeeds shadowMap)
    : lights_(scene.lights), shadow_(library, lights_.shadowCaster(), shadowMap) {
  const mres::params::EnvironmentParams environment = environmentParams(scene);
  ambient_ = {glm::vec3(environment.ambientAbove), glm::vec3(environment.ambientBelow)};
  environment_.upload(environment);
}

void Illumination::update(const GpuScene& scene, const Camera& camera, const CameraView& view, float aspect,
                          mres::gl::Profiler& profiler) {
  shadow_.draw(scene, camera, view, aspect, profiler);
  lightBlock_.upload(lights_.params(view.origin));
}

void Illumination::connect(const mres::gl::Program& program) {
  ShadowPass::connect(program);
  program.setBlockBinding("EnvironmentParams", bindings::kEnvironment);
  program.setBlockBinding("LightParams", bindings::kLights);
}

void Illumination::bind() const {
  shadow_.bind();
  environment_.bind(bindings::kEnvironment);
  lightBlock_.bind(bindings::kLights);
}

}  // namespace host
