#include "host/peers/tile_rate_pass.h"

#include "host/peers/peer_shaders.h"
#include "mres/mask/zone_pass.h"
#include "shaders/peers/peer_blocks.h"

namespace host {

TileRatePass::TileRatePass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect)
    : program_(mres::makePassProgram(library, "peers/tile_rates.frag", effectDefines(effect))),
      outside_(mres::makePassProgram(library, "peers/outside_tiles.frag")) {}

void TileRatePass::draw(const PeerFrame& frame, const mres::gl::Texture2D& quarter, float threshold) {
  const mres::gl::Scope scope(frame.context.profiler, "mres.rates");
  ensure(rates_, (frame.size + ADAPTIVE_TILE - 1) / ADAPTIVE_TILE, GL_R8, "mres.rates");
  mres::gl::bindTexture(mres::kSourceUnit, quarter.id(), frame.context.nearest);
  frame.use(program_);
  glUniform1f(program_.uniformLocation("threshold"), threshold);
  rates_.bind();
  frame.context.triangle.draw();
}

void TileRatePass::startZone(const PeerFrame& frame, const mres::gl::RenderTarget& target) const {
  const mres::gl::Scope scope(frame.context.profiler, "mres.stencil");
  mres::gl::bindTexture(mres::kZoneUnit, rates_.color().id(), frame.context.nearest);
  target.bind();
  mres::startZone();
  glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  frame.use(outside_);
  frame.context.triangle.draw();
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace host
