// The deferred host: shadow map, G-buffer, ambient occlusion through mres, lighting, tone map.
#pragma once

#include <memory>

#include "host/image/image_file.h"
#include "host/scene/scene.h"
#include "mres/gl/profiler.h"

namespace host {

/// The G-buffer's textures of the last draw, as any engine would hand them to mres.
struct GBufferTextures {
  GLuint depth = 0;             ///< GL_DEPTH_COMPONENT32F, window depth 0..1, 1 is the far plane
  GLuint albedo = 0;            ///< GL_SRGB8_ALPHA8
  GLuint normal = 0;            ///< shading normal in world space, GL_RGB10_A2, n * 0.5 + 0.5
  GLuint geometricNormal = 0;   ///< interpolated vertex normal before normal mapping, same encoding
  GLuint material = 0;          ///< GL_RGBA8: roughness, metallic, free, free
  GLuint emissive = 0;          ///< GL_R11F_G11F_B10F
};

/// Renders one scene. Uploads it once; draws any camera at any size.
class Renderer {
 public:
  Renderer(const Scene& scene, mres::gl::Profiler& profiler);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws shadow map (where not yet done) and G-buffer for `camera`.
  const GBufferTextures& drawGeometry(const Camera& camera, glm::ivec2 size);

  /// Lights the G-buffer of the last drawGeometry() into an RGBA16F texture of linear radiance. `ambientOcclusion` is a
  /// texture of accessibility 0..1 in red, of the same size, that multiplies the ambient term; 0 is none.
  GLuint drawLighting(GLuint ambientOcclusion);

  /// Tone maps the lit picture into an sRGB-encoded 8-bit texture of the same size.
  GLuint drawToneMap();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Reads a colour texture back, flipped so that rows run top to bottom.
FloatImage readTexture(GLuint texture, glm::ivec2 size, int channels);

}  // namespace host
