// The deferred host: shadow map, G-buffer, lighting, transparency, tone map. What screen-space effects add
// comes from outside, between drawGeometry() and drawLighting(); see screen_effects.h.
#pragma once

#include <memory>
#include <string>

#include "host/renderer/gbuffer_textures.h"
#include "host/renderer/read_texture.h"
#include "host/renderer/screen_effects.h"
#include "host/scene/scene.h"
#include "mres/gl/profiler.h"
#include "mres/settings.h"

namespace host {

/// Smaller ones would be all margin.
inline constexpr int kLeastShadowMapSize = 64;

struct RendererSettings {
  int shadowMapSize = 2048;  ///< texels, [64, 16384]. Side of the shadow map.
  float shadowReach = 0.0f;  ///< metres. How far beyond a surface effects that filter the shadow map look.
  float exposureCompensation = 0.0f;  ///< stops, [-10, 10]. Brightens the tone-mapped picture.
  std::string shaderDirectory{};  ///< Shader files found below it win over the embedded ones. Empty: none.
};

template <class Visitor>
void visit(RendererSettings& settings, Visitor&& visitor) {
  visitor("shadowMapSize", settings.shadowMapSize,
          mres::SettingInfo{"texels", kLeastShadowMapSize, 16384.0, "Side of the shadow map."});
  visitor("exposureCompensation", settings.exposureCompensation,
          mres::SettingInfo{"stops", -10.0, 10.0, "Brightens the tone-mapped picture."});
}

/// Renders one scene. Uploads it once; draws any camera at any size. It sets the OpenGL state that its
/// passes use, and leaves it changed: the context is the host's own.
class Renderer {
 public:
  /// `profiler` must outlive the renderer; `scene` need not. Throws std::runtime_error with a sentence if the
  /// device cannot hold the scene.
  Renderer(const Scene& scene, mres::gl::Profiler& profiler, const RendererSettings& settings = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer(Renderer&&) = delete;
  Renderer& operator=(Renderer&&) = delete;

  /// Draws the shadow map (unless it is the same as before) and the G-buffer for `camera`. Throws
  /// std::runtime_error with a sentence if the device cannot draw pictures of that size.
  const GBufferTextures& drawGeometry(const Camera& camera, glm::ivec2 size);

  /// Lights the G-buffer of the last drawGeometry() into an RGBA16F texture of linear radiance: opaque
  /// surfaces, and the sky behind them.
  GLuint drawOpaqueLighting(const ScreenEffects& effects);

  /// The same, with transparent surfaces over it, in the same texture.
  GLuint drawLighting(const ScreenEffects& effects);

  /// Tone maps the lit picture of the last drawLighting() into an sRGB-encoded RGBA8 texture of the same
  /// size.
  GLuint drawToneMap();

  /// World to view and view to clip of the last drawGeometry().
  [[nodiscard]] const glm::mat4& view() const;
  [[nodiscard]] const glm::mat4& projection() const;

  /// The shadow map of the last drawGeometry().
  [[nodiscard]] ShadowMap shadowMap() const;

  [[nodiscard]] AmbientLight ambient() const;

  /// Lights that are not drawn, the dimmest ones of a scene that has more than the shaders take.
  [[nodiscard]] std::size_t lightsLeftOut() const;

  /// The factor on radiance that shows the scene well. The tone map multiplies the display's
  /// exposureCompensation as well.
  [[nodiscard]] float exposure() const;

  /// Bytes of the scene and of all targets on the GPU.
  [[nodiscard]] std::size_t gpuBytes() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace host
