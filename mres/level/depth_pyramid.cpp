#include "mres/level/depth_pyramid.h"

#include <algorithm>

namespace mres {
namespace {

/// Mips beyond the sixth are too small for a cache to care.
constexpr int kMaxMips = 6;

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
  texture_ = gl::Texture2D(GL_R32F, fullSize, "mres.depth", depthPyramidLevels(fullSize));
  framebuffers_.clear();
  for (int mip = 0; mip < texture_.levels(); ++mip) {
    const gl::FramebufferName& framebuffer = framebuffers_.emplace_back(gl::FramebufferName::create());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), mip);
  }
}

void DepthPyramid::draw(PassContext& context, glm::ivec2 fullSize) {
  const gl::Scope scope(context.profiler, "mres.depth");
  if (texture_.size() != fullSize) resize(fullSize);
  glUseProgram(program_.id());
  for (int mip = 0; mip < texture_.levels(); ++mip) {
    const glm::ivec2 size = glm::max(fullSize >> mip, glm::ivec2(1));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[static_cast<std::size_t>(mip)].id());
    glViewport(0, 0, size.x, size.y);
    glUniform1i(levelLocation_, mip);
    context.triangle.draw();
  }
}

}  // namespace mres
