#pragma once

#include <vector>

#include "host/peers/peer.h"
#include "host/peers/peer_frame.h"
#include "mres/gl/state_guard.h"
#include "mres/gl/uniform_buffer.h"
#include "shaders/mres/frame_params.h"

namespace host {

/// What the peers have in common: a frame is set up as mres does it, and each draws it in its own way.
class PeerBase : public Peer {
 public:
  GLuint render(mres::Effect& effect, const mres::Frame& frame) final;
  void setProfiling(mres::gl::Profiler::Mode mode) final { context_.profiler.setMode(mode); }
  [[nodiscard]] const std::vector<mres::gl::StageTime>& stages() const final {
    return context_.profiler.stages();
  }
  [[nodiscard]] std::size_t bytes() const override;
  void fillTargets(float value) final;

 protected:
  /// `fragment`, a string literal, runs the effect's shade().
  PeerBase(const mres::EffectDescription& effect, const PeerOptions& options,
           const char* fragment = "mres/effect_level.frag");

  [[nodiscard]] const mres::gl::ShaderLibrary& library() const { return context_.library; }

 private:
  /// Returns the effect's values.
  virtual const mres::gl::Texture2D& draw(const PeerFrame& frame) = 0;
  /// Made or not.
  [[nodiscard]] virtual std::vector<const mres::gl::RenderTarget*> targets() const = 0;

  void bindFrame(const mres::Frame& frame, mres::params::FrameParams& params);
  void bindEffect(mres::Effect& effect, const mres::Frame& frame);

  GLuint viewports_ = mres::gl::StateGuard::countViewports();
  mres::PassContext context_;
  mres::gl::UniformBuffer<mres::params::FrameParams> frameBlock_;
  mres::EffectProgram effect_;
  mres::DepthPyramid pyramid_;
};

}  // namespace host
