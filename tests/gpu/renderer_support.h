// Small scenes made in code, and reading what the renderer makes of them.
#pragma once

#include "host/image/image_file.h"
#include "host/renderer/renderer.h"
#include "tests/support/gl_test.h"

namespace host::test {

inline constexpr glm::ivec2 kSize{64, 48};

/// A square of two metres in the xy plane around the origin that faces +Z, with the texture upright.
Mesh square(int material = -1);

/// A cube of two metres around the origin.
Mesh cube(int material = -1);

/// A white, rough, non-metallic material.
Material chalk();

/// A sun that travels along `direction`.
Light sunAlong(glm::vec3 direction, float lux);

/// A scene without any light but what its materials emit.
Scene darkScene();

/// Adds a mesh with a material, and one instance.
void place(Scene& scene, const Mesh& mesh, const Material& material,
           const glm::mat4& transform = glm::mat4(1.0f));

/// Adds an RGBA image and a texture of it; returns the texture's index.
int addTexture(Scene& scene, glm::ivec2 size, std::vector<std::uint8_t> pixels);

/// A camera on the +Z axis that looks at the origin.
Camera frontCamera(float distance = 3.0f);

/// Pixel (x, y) from the upper left.
glm::vec4 pixel(const FloatImage& image, glm::ivec2 at);
glm::vec4 centre(const FloatImage& image);

/// All of the G-buffer.
struct GBuffer {
  FloatImage depth;
  FloatImage albedo;
  FloatImage normal;
  FloatImage geometricNormal;
  FloatImage material;
  FloatImage emissive;
};

glm::vec3 unpackNormal(glm::vec4 texel);

/// A fixture with a profiler; fails if a test leaves an OpenGL error.
class RendererTest : public mres::test::GlTest {
 protected:
  GBuffer drawGBuffer(const Scene& scene, const Camera& camera, glm::ivec2 size = kSize);
  /// Linear radiance.
  FloatImage drawLit(const Scene& scene, const Camera& camera, glm::ivec2 size = kSize);
  mres::gl::Profiler& profiler() { return profiler_; }

 private:
  mres::gl::Profiler profiler_;
};

}  // namespace host::test
