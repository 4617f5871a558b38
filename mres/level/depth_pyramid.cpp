#include "mres/level/depth_pyramid.h"

#include <algorithm>
#include <utility>

#include "mres/gl/render_target.h"

namespace mres {
namespace {

/// Mips beyond the sixth are too small for a cache to care.
constexpr int kMaxMips = 6;

constexpr const char* kLabel = "mres.depth";

}  // namespace

int depthPyramidLevels(glm::ivec2 fullSize) {
  int count = 1;
  while (count < kMaxMips && std::min(fullSize.x, fullSize.y) >> count > 0) ++count;
  return count;
}

DepthPyramid::DepthPyramid(const gl::ShaderLibrary& library)
    : program_(makePassProgram(library, "mres/depth_pyramid.frag")),
      levelLocation_(program_.uniformLocation("pyramidLevel")) {}

void DepthPyramid::resize(glm::ivec2 fullSize) {
  gl::Texture2D texture(GL_R32F, fullSize, kLabel, depthPyramidLevels(fullSize));
  std::vector<gl::FramebufferName> framebuffers;
  for (int mip = 0; mip < texture.levels(); ++mip) {
    const gl::FramebufferName& framebuffer = framebuffers.emplace_back(gl::FramebufferName::create());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), mip);
    gl::requireComplete(kLabel);
  }
  texture_ = std::move(texture);
  framebuffers_ = std::move(framebuffers);
}

void DepthPyramid::fill(float value) {
  frame_ = 0;
  const glm::vec4 texel(value);
  for (const gl::FramebufferName& framebuffer : framebuffers_) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glClearBufferfv(GL_COLOR, 0, &texel.x);
  }
}

bool DepthPyramid::draw(PassContext& context, const Frame& frame) {
  const bool resized = texture_.size() != frame.size;
  if (!resized && frame.id != 0 && frame.id == frame_) return false;
  const gl::Scope scope(context.profiler, kLabel);
  if (resized) resize(frame.size);
  frame_ = frame.id;
  glUseProgram(program_.id());
  for (int mip = 0; mip < texture_.levels(); ++mip) {
    const glm::ivec2 size = glm::max(frame.size >> mip, glm::ivec2(1));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[static_cast<std::size_t>(mip)].id());
    glViewport(0, 0, size.x, size.y);
    glUniform1i(levelLocation_, mip);
    context.triangle.draw();
  }
  return true;
}

}  // namespace mres
