#include "mres/gl/render_target.h"

#include <array>
#include <numeric>
#include <stdexcept>
#include <string>

#include "mres/gl/label.h"

namespace mres::gl {
namespace {

constexpr std::array<GLenum, 8> kAttachments = {
    GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3,
    GL_COLOR_ATTACHMENT4, GL_COLOR_ATTACHMENT5, GL_COLOR_ATTACHMENT6, GL_COLOR_ATTACHMENT7};

[[noreturn]] void throwRejected(const char* label) {
  throw std::runtime_error(std::string("The OpenGL driver rejects the render target '") + label +
                           "'; update the driver or reduce the size.");
}

bool isComplete() {
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

void requireComplete(const char* label) {
  if (!isComplete()) throwRejected(label);
}

StencilBuffer::StencilBuffer(glm::ivec2 size, const char* label) {
  struct Choice {
    GLenum format, attachment;
    std::size_t bytesPerPixel;
  };
  // One byte a pixel where the driver can; some reject a stencil without depth.
  constexpr std::array kChoices = {Choice{GL_STENCIL_INDEX8, GL_STENCIL_ATTACHMENT, 1},
                                   Choice{GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, 4}};
  for (const Choice& choice : kChoices) {
    renderbuffer_ = RenderbufferName::create();
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, choice.format, size.x, size.y);
    setLabel(GL_RENDERBUFFER, renderbuffer_.id(), label);
    attachment_ = choice.attachment;
    bytes_ = choice.bytesPerPixel * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);

    const FramebufferName trial = FramebufferName::create();
    glBindFramebuffer(GL_FRAMEBUFFER, trial.id());
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    attach();
    if (isComplete()) return;
  }
  throwRejected(label);
}

void StencilBuffer::attach() const {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment_, GL_RENDERBUFFER, renderbuffer_.id());
}

RenderTarget::RenderTarget(glm::ivec2 size, std::initializer_list<GLenum> colorFormats, GLenum depthFormat,
                           const char* label)
    : framebuffer_(FramebufferName::create()), size_(size) {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  for (const GLenum format : colorFormats) addColor(format, label);
  if (depthFormat != 0) {
    depthStencil_ = Texture2D(depthFormat, size, label);
    const bool hasStencil = formatInfo(depthFormat).format == GL_DEPTH_STENCIL;
    glFramebufferTexture2D(GL_FRAMEBUFFER, hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                           GL_TEXTURE_2D, depthStencil_.id(), 0);
  }
  finish(label);
}

RenderTarget::RenderTarget(glm::ivec2 size, std::initializer_list<GLenum> colorFormats,
                           const StencilBuffer& stencil, const char* label)
    : framebuffer_(FramebufferName::create()), size_(size) {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  for (const GLenum format : colorFormats) addColor(format, label);
  stencil.attach();
  finish(label);
}

void RenderTarget::addColor(GLenum format, const char* label) {
  const GLenum attachment = kAttachments.at(colors_.size());
  const Texture2D& texture = colors_.emplace_back(format, size_, label);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
}

void RenderTarget::finish(const char* label) const {
  if (colors_.empty()) {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  } else {
    glDrawBuffers(static_cast<GLsizei>(colors_.size()), kAttachments.data());
  }
  setLabel(GL_FRAMEBUFFER, id(), label);
  requireComplete(label);
}

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  glViewport(0, 0, size_.x, size_.y);
}

void RenderTarget::fill(glm::vec4 value) const {
  if (colors_.empty()) return;
  bind();
  for (std::size_t i = 0; i < colors_.size(); ++i) glClearBufferfv(GL_COLOR, static_cast<GLint>(i), &value.x);
}

std::size_t RenderTarget::bytes() const {
  return std::accumulate(colors_.begin(), colors_.end(), depthStencil_.bytes(),
                         [](std::size_t sum, const Texture2D& texture) { return sum + texture.bytes(); });
}

}  // namespace mres::gl
