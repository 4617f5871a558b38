#include "mres/gl/render_target.h"

#include <algorithm>
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

void attach(GLenum attachment, const Texture2D& texture) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
}

}  // namespace

RenderTarget::RenderTarget(glm::ivec2 size, std::initializer_list<GLenum> colorFormats,
                           GLenum depthStencilFormat, const char* label)
    : framebuffer_(FramebufferName::create()), size_(size) {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  for (const GLenum format : colorFormats) {
    attach(kAttachments.at(colors_.size()), colors_.emplace_back(format, size, label));
  }
  if (depthStencilFormat == GL_STENCIL_INDEX8) {
    attachStencil(label);
  } else if (depthStencilFormat != 0) {
    depthStencil_ = Texture2D(depthStencilFormat, size, label);
    const bool hasStencil = formatInfo(depthStencilFormat).format == GL_DEPTH_STENCIL;
    attach(hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depthStencil_);
  }
  if (colors_.empty()) {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  } else {
    glDrawBuffers(static_cast<GLsizei>(colors_.size()), kAttachments.data());
  }
  setLabel(GL_FRAMEBUFFER, id(), label);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(std::string("The OpenGL driver rejects the render target '") + label +
                             "'; update the driver or reduce the size.");
  }
}

void RenderTarget::attachStencil(const char* label) {
  struct Choice {
    GLenum format, attachment;
    std::size_t bytesPerPixel;
  };
  // One byte a pixel where the driver can; some reject a stencil without depth.
  constexpr std::array kChoices = {Choice{GL_STENCIL_INDEX8, GL_STENCIL_ATTACHMENT, 1},
                                   Choice{GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, 4}};
  for (const Choice& choice : kChoices) {
    stencil_ = RenderbufferName::create();
    glBindRenderbuffer(GL_RENDERBUFFER, stencil_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, choice.format, size_.x, size_.y);
    setLabel(GL_RENDERBUFFER, stencil_.id(), label);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, choice.attachment, GL_RENDERBUFFER, stencil_.id());
    stencilBytes_ =
        choice.bytesPerPixel * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  }
}

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  glViewport(0, 0, size_.x, size_.y);
}

std::size_t RenderTarget::bytes() const {
  return std::accumulate(colors_.begin(), colors_.end(), depthStencil_.bytes() + stencilBytes_,
                         [](std::size_t sum, const Texture2D& texture) { return sum + texture.bytes(); });
}

}  // namespace mres::gl
