#include "host/peers/upsample_pass.h"

#include "host/peers/peer_shaders.h"
#include "mres/mask/zone_pass.h"

namespace host {
namespace {

std::string definesOf(const mres::EffectDescription& effect, Upsampling upsampling) {
  return effectDefines(effect) + define("JOINT", upsampling == Upsampling::joint ? 1 : 0);
}

void drawOutsideZone() {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_NOTEQUAL, mres::kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

}  // namespace

UpsamplePass::UpsamplePass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect,
                           Upsampling upsampling)
    : program_(mres::makePassProgram(library, "peers/upsample.frag", definesOf(effect, upsampling))) {}

void UpsamplePass::draw(const PeerFrame& frame, const mres::gl::Texture2D& coarser,
                        const mres::gl::RenderTarget& target, bool outsideZone) const {
  const mres::gl::Scope scope(frame.context.profiler, "mres.upsample");
  mres::gl::bindTexture(mres::kCoarserUnit, coarser.id(), frame.context.linear);
  target.bind();
  if (outsideZone) drawOutsideZone();
  frame.use(program_);
  frame.context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

}  // namespace host
