#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "mres/gl/texture.h"

namespace mres::gl {

/// Throws std::runtime_error if the driver rejects the framebuffer bound for drawing.
void requireComplete(const char* label);

/// A stencil of eight bits that several render targets of one size share.
class StencilBuffer {
 public:
  StencilBuffer() = default;
  /// Throws std::runtime_error if the driver can render to no stencil at all.
  StencilBuffer(glm::ivec2 size, const char* label);

  /// Attaches it to the framebuffer bound for drawing.
  void attach() const;
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  RenderbufferName renderbuffer_;
  GLenum attachment_ = 0;
  std::size_t bytes_ = 0;
};

/// A framebuffer with colour textures and, where asked for, a depth texture or a shared stencil, all of one
/// size.
class RenderTarget {
 public:
  RenderTarget() = default;
  /// `depthFormat` 0 is none. Throws std::runtime_error if the driver rejects the combination.
  RenderTarget(glm::ivec2 size, std::initializer_list<GLenum> colorFormats, GLenum depthFormat,
               const char* label);
  /// With a stencil that outlives this target.
  RenderTarget(glm::ivec2 size, std::initializer_list<GLenum> colorFormats, const StencilBuffer& stencil,
               const char* label);

  /// Binds it for drawing with the viewport over all of it.
  void bind() const;
  /// Gives every colour texture `value`; binds it as bind() does. Nothing if there are none.
  void fill(glm::vec4 value) const;
  void fill(float value) const { fill(glm::vec4(value)); }
  [[nodiscard]] const Texture2D& color(std::size_t index = 0) const { return colors_.at(index); }
  [[nodiscard]] const Texture2D& depthStencil() const { return depthStencil_; }
  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] GLuint id() const { return framebuffer_.id(); }
  /// Of the textures; a shared stencil counts its own.
  [[nodiscard]] std::size_t bytes() const;
  explicit operator bool() const { return static_cast<bool>(framebuffer_); }

 private:
  void addColor(GLenum format, const char* label);
  void finish(const char* label) const;

  FramebufferName framebuffer_;
  std::vector<Texture2D> colors_;
  Texture2D depthStencil_;
  glm::ivec2 size_{0};
};

}  // namespace mres::gl
