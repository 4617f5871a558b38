#pragma once

#include "mres/gl/object.h"
#include "mres/gl/program.h"

namespace mres::test {

/// Sets every piece of OpenGL state that a draw depends on to a value that would spoil it, as an engine in
/// the middle of its frame might, and OpenGL's defaults when it ends.
class HostileState {
 public:
  HostileState();
  ~HostileState();
  HostileState(const HostileState&) = delete;
  HostileState& operator=(const HostileState&) = delete;

 private:
  void bindObjects();
  void bindTextures();

  gl::Program program_;
  gl::FramebufferName drawFramebuffer_ = gl::FramebufferName::create();
  gl::FramebufferName readFramebuffer_ = gl::FramebufferName::create();
  gl::RenderbufferName renderbuffer_ = gl::RenderbufferName::create();
  gl::VertexArrayName vertexArray_ = gl::VertexArrayName::create();
  gl::BufferName buffer_ = gl::BufferName::create();
  gl::BufferName feedbackBuffer_ = gl::BufferName::create();
  gl::SamplerName sampler_ = gl::SamplerName::create();
  gl::TextureName texture2D_ = gl::TextureName::create();
  gl::TextureName textureCube_ = gl::TextureName::create();
  gl::TextureName texture3D_ = gl::TextureName::create();
  gl::TextureName textureArray_ = gl::TextureName::create();
};

}  // namespace mres::test
