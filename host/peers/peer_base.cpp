#include "host/peers/peer_base.h"

#include "host/peers/peer_shaders.h"
#include "mres/embedded_shaders.h"
#include "mres/level/frame_params.h"
#include "mres/level/frame_textures.h"
#include "mres/validate.h"

namespace host {
namespace {

mres::PassContext makeContext(const PeerOptions& options) {
  mres::PassContext context;
  context.library.add(mres::embeddedShaders());
  context.library.add(peerShaders());
  context.library.setDirectory(options.shaderDirectory);
  return context;
}

}  // namespace

PeerBase::PeerBase(const mres::EffectDescription& effect, const PeerOptions& options, const char* fragment)
    : context_(makeContext(options)),
      effect_(context_.library, effect, fragment),
      pyramid_(context_.library) {}

void PeerBase::bindFrame(const mres::Frame& frame, mres::params::FrameParams& params) {
  params.depthRounding = mres::depthRounding(mres::bindFrameTextures(context_, frame));
  frameBlock_.upload(params);
  frameBlock_.bind(mres::kFrameBlock);
}

void PeerBase::bindEffect(mres::Effect& effect, const mres::Frame& frame) {
  const mres::gl::Scope scope(context_.profiler, "mres.inputs");
  effect.bind(frame);
}

GLuint PeerBase::render(mres::Effect& effect, const mres::Frame& frame) {
  mres::params::FrameParams params = mres::frameParams(frame);
  mres::validate(effect.levels());
  effect_.expectSame(effect);
  const mres::gl::StateGuard guard(viewports_);
  bindFrame(frame, params);
  context_.profiler.beginFrame();
  effect_.setUp(effect);
  if (effect.description().readsPyramid) pyramid_.draw(context_, frame);
  bindEffect(effect, frame);
  const PeerFrame prepared{context_, effect_, pyramid_, effect.levels(), frame.size, effect.background()};
  const GLuint values = draw(prepared).id();
  context_.profiler.endFrame();
  return values;
}

std::size_t PeerBase::bytes() const {
  std::size_t sum = pyramid_.bytes();
  for (const mres::gl::RenderTarget* target : targets()) sum += target->bytes();
  return sum;
}

void PeerBase::fillTargets(float value) {
  const mres::gl::StateGuard guard(viewports_);
  pyramid_.fill(value);
  for (const mres::gl::RenderTarget* target : targets()) target->fill(value);
}

}  // namespace host
