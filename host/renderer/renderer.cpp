#include "host/renderer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/renderer/bindings.h"
#include "host/renderer/embedded_shaders.h"
#include "host/renderer/gbuffer/gbuffer_pass.h"
#include "host/renderer/lighting/lighting_pass.h"
#include "host/renderer/post/exposure.h"
#include "host/renderer/post/tone_map_pass.h"
#include "host/renderer/transparency/transparent_pass.h"

namespace host {
namespace {

int largestSize() {
  std::array<GLint, 2> viewport{};
  GLint texture = 0;
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  return std::min({viewport[0], viewport[1], texture});
}

void checkSize(glm::ivec2 size) {
  const int largest = largestSize();
  if (std::min(size.x, size.y) >= 1 && std::max(size.x, size.y) <= largest) return;
  throw std::runtime_error("Pictures of " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                           " pixels cannot be drawn; this OpenGL device takes 1 to " +
                           std::to_string(largest) + " a side.");
}

RendererSettings checked(const RendererSettings& settings) {
  if (settings.shadowMapSize < kLeastShadowMapSize || settings.shadowMapSize > largestSize()) {
    throw std::runtime_error("A shadow map of " + std::to_string(settings.shadowMapSize) +
                             " texels a side cannot be made; this OpenGL device takes " +
                             std::to_string(kLeastShadowMapSize) + " to " + std::to_string(largestSize()) +
                             ".");
  }
  return settings;
}

ShadowMapNeeds shadowMapNeeds(const RendererSettings& settings) {
  return {checked(settings).shadowMapSize, settings.shadowReach};
}

}  // namespace

struct Renderer::Implementation {
  Implementation(const Scene& scene, mres::gl::Profiler& frameProfiler, const RendererSettings& settings)
      : profiler(frameProfiler),
        library(shaderLibrary(settings.shaderDirectory)),
        gpuScene(scene),
        illumination(scene, library, shadowMapNeeds(settings)),
        gbufferPass(library),
        lightingPass(library),
        transparentPass(library),
        toneMapPass(library),
        exposure(exposureOf(scene, gpuScene.instances().bounds())),
        compensation(std::exp2(settings.exposureCompensation)) {}

  void drawGeometry(const Camera& camera, glm::ivec2 pictureSize) {
    size = pictureSize;
    cameraView = CameraView(camera, size);
    worldToView = viewMatrix(camera);
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    illumination.update(gpuScene, camera, cameraView, aspect, profiler);
    viewBlock.upload(cameraView.params());
    viewBlock.bind(bindings::kView);
    gbufferPass.draw(gpuScene, cameraView, size, profiler);
  }

  void drawOpaqueLighting(ScreenEffects effects) {
    if (effects.accessibility == 0) effects.accessibility = gpuScene.white();
    viewBlock.bind(bindings::kView);
    illumination.bind();
    lightingPass.draw(gbufferPass.textures(), {effects, exposure}, size, profiler);
  }

  void drawLighting(const ScreenEffects& effects) {
    drawOpaqueLighting(effects);
    transparentPass.draw(gpuScene, cameraView, lightingPass.radiance(), gbufferPass.textures().depth,
                         profiler);
  }

  mres::gl::Profiler& profiler;
  mres::gl::ShaderLibrary library;
  GpuScene gpuScene;
  Illumination illumination;
  GBufferPass gbufferPass;
  LightingPass lightingPass;
  TransparentPass transparentPass;
  ToneMapPass toneMapPass;
  mres::gl::UniformBuffer<mres::params::ViewParams> viewBlock;
  float exposure;      // the scene's
  float compensation;  // the display's
  glm::ivec2 size{1};
  CameraView cameraView{Camera{}, glm::ivec2(1)};
  glm::mat4 worldToView{1.0f};
};

Renderer::Renderer(const Scene& scene, mres::gl::Profiler& profiler, const RendererSettings& settings)
    : implementation_(std::make_unique<Implementation>(scene, profiler, settings)) {}

Renderer::~Renderer() = default;

const GBufferTextures& Renderer::drawGeometry(const Camera& camera, glm::ivec2 size) {
  checkSize(size);
  implementation_->drawGeometry(camera, size);
  return implementation_->gbufferPass.textures();
}

GLuint Renderer::drawOpaqueLighting(const ScreenEffects& effects) {
  implementation_->drawOpaqueLighting(effects);
  return implementation_->lightingPass.radiance().id();
}

GLuint Renderer::drawLighting(const ScreenEffects& effects) {
  implementation_->drawLighting(effects);
  return implementation_->lightingPass.radiance().id();
}

GLuint Renderer::drawToneMap() {
  Implementation& self = *implementation_;
  self.toneMapPass.draw(self.lightingPass.radiance(), self.exposure * self.compensation, self.profiler);
  return self.toneMapPass.picture().id();
}

const glm::mat4& Renderer::view() const {
  return implementation_->worldToView;
}

const glm::mat4& Renderer::projection() const {
  return implementation_->cameraView.projection;
}

ShadowMap Renderer::shadowMap() const {
  return implementation_->illumination.shadow().shadow(implementation_->cameraView);
}

AmbientLight Renderer::ambient() const {
  return implementation_->illumination.ambient();
}

std::size_t Renderer::lightsLeftOut() const {
  return implementation_->illumination.lights().leftOut();
}

float Renderer::exposure() const {
  return implementation_->exposure;
}

std::size_t Renderer::gpuBytes() const {
  const Implementation& self = *implementation_;
  return self.gpuScene.bytes() + self.illumination.shadow().map().bytes() + self.gbufferPass.bytes() +
         self.lightingPass.bytes() + self.toneMapPass.bytes();
}

}  // namespace host
