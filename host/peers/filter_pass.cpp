#include "host/peers/filter_pass.h"

#include "host/peers/peer_shaders.h"
#include "mres/mask/zone_pass.h"

namespace host {
namespace {

constexpr const char* kScope = "mres.filter";

void draw(const mres::PassContext& context, const mres::gl::Program& program,
          const mres::gl::Texture2D& source) {
  mres::gl::bindTexture(mres::kSourceUnit, source.id(), context.nearest);
  glUseProgram(program.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

}  // namespace

FilterPass::FilterPass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect)
    : alongX_(mres::makePassProgram(library, "mres/filter_horizontal.frag", effectDefines(effect))),
      alongY_(mres::makePassProgram(library, "peers/filter_vertical.frag", effectDefines(effect))) {}

void FilterPass::alongX(const PeerFrame& frame, const mres::gl::Texture2D& source,
                        const mres::gl::RenderTarget& target, bool zoned) const {
  const mres::gl::Scope scope(frame.context.profiler, kScope);
  target.bind();
  if (zoned) mres::clearAndDrawInZone();
  draw(frame.context, alongX_, source);
}

void FilterPass::alongY(const PeerFrame& frame, const mres::gl::Texture2D& source,
                        const mres::gl::RenderTarget& target, bool zoned) const {
  const mres::gl::Scope scope(frame.context.profiler, kScope);
  target.bind();
  if (zoned) mres::drawInZone();
  draw(frame.context, alongY_, source);
}

}  // namespace host
