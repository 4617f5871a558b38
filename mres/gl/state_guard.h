#pragma once

#include <array>
#include <glm/glm.hpp>

#include "mres/gl/object.h"

namespace mres::gl {

/// How much of the binding state mres uses; the guard saves exactly that much.
inline constexpr GLuint kTextureUnits = 12;
inline constexpr GLuint kUniformBindings = 5;

/// Saves every piece of OpenGL state that mres changes or depends on, sets it to OpenGL's defaults, and puts
/// the host's values back when it ends. Exists once per public call, so that no call leaks state into the
/// host or inherits hostile state from it.
class StateGuard {
 public:
  /// How many viewports the current context has: those of OpenGL 4.1, else one. Asks for the version and the
  /// extensions, so ask once per context.
  static GLuint countViewports();

  /// `viewports` is the context's countViewports().
  explicit StateGuard(GLuint viewports);
  ~StateGuard();
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

 private:
  struct StencilFace {
    GLint func, ref, valueMask, writeMask, fail, depthFail, depthPass;
  };
  struct TextureUnit {
    GLint texture, sampler;
  };
  struct UniformBinding {
    GLint buffer;
    GLint64 start, size;
  };
  struct Viewport {
    glm::vec4 rectangle;
    GLboolean scissored;
  };
  static constexpr GLuint kDrawBuffers = 4;
  static constexpr GLuint kMaxViewports = 16;
  static constexpr std::size_t kCapabilities = 24;

  void saveBindings();
  void saveRasterState();
  void saveViewports();
  void setDefaults() const;
  void restoreBindings() const;
  void restoreRasterState() const;
  void restoreViewports() const;

  GLint program_ = 0, vertexArray_ = 0, drawFramebuffer_ = 0, readFramebuffer_ = 0, renderbuffer_ = 0;
  GLint activeTexture_ = 0, uniformBuffer_ = 0, pixelUnpackBuffer_ = 0, pixelPackBuffer_ = 0;
  std::array<TextureUnit, kTextureUnits> textureUnits_{};
  std::array<UniformBinding, kUniformBindings> uniformBindings_{};
  std::array<GLboolean, kCapabilities> capabilities_{};
  std::array<std::array<GLboolean, 4>, kDrawBuffers> colorMasks_{};
  std::array<GLboolean, kDrawBuffers> blendEnabled_{};
  std::array<StencilFace, 2> stencil_{};
  std::array<Viewport, kMaxViewports> viewports_{};
  GLuint viewportCount_;
  GLboolean depthMask_ = GL_TRUE;
  std::array<GLint, 2> polygonMode_{};
};

}  // namespace mres::gl
