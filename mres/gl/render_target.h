#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "mres/gl/texture.h"

namespace mres::gl {

/// A framebuffer with colour textures and, where asked for, a depth texture or a stencil renderbuffer, all of
/// one size.
class RenderTarget {
 public:
  RenderTarget() = default;
  /// `depthStencilFormat` 0 is none; GL_STENCIL_INDEX8 asks for a stencil that is never read back, in
  /// whatever format the driver can render to. Throws std::runtime_error if the driver rejects the
  /// combination.
  RenderTarget(glm::ivec2 size, std::initializer_list<GLenum> colorFormats, GLenum depthStencilFormat,
               const char* label);

  /// Binds it for drawing with the viewport over all of it.
  void bind() const;
  [[nodiscard]] const Texture2D& color(std::size_t index = 0) const { return colors_.at(index); }
  [[nodiscard]] const Texture2D& depthStencil() const { return depthStencil_; }
  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] GLuint id() const { return framebuffer_.id(); }
  [[nodiscard]] std::size_t bytes() const;
  explicit operator bool() const { return static_cast<bool>(framebuffer_); }

 private:
  void attachStencil(const char* label);

  FramebufferName framebuffer_;
  std::vector<Texture2D> colors_;
  Texture2D depthStencil_;
  RenderbufferName stencil_;
  std::size_t stencilBytes_ = 0;
  glm::ivec2 size_{0};
};

}  // namespace mres::gl
