#pragma once

#include <array>

#include "mres/gl/render_target.h"
#include "mres/level/level_targets.h"
#include "mres/level/pass_context.h"

namespace mres {

/// The stencil value of a level's zone; elsewhere it is 0.
inline constexpr GLint kZone = 1;

/// Finds where each level renders, in blocks of ZONE_BLOCK x ZONE_BLOCK of its pixels: where its mask is
/// above zero (section 4.1 of the paper), or where its edges and the coarser level say that it makes a
/// difference (the progressive decomposition of section 6).
class ZonePass {
 public:
  explicit ZonePass(const gl::ShaderLibrary& library);

  /// Needs the frame's and the level's blocks bound.
  void draw(PassContext& context, const PlannedLevel& level, const ZoneInputs& inputs);

  /// GL_R8, ceil(level size / ZONE_BLOCK): 1 where the level renders.
  [[nodiscard]] const gl::Texture2D& zone(int level) const { return zones_.at(slot(level)).color(); }
  void fill(float value) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  static std::size_t slot(int level) { return static_cast<std::size_t>(level); }

  [[nodiscard]] const gl::Program& programOf(const ZoneInputs& inputs) const;

  gl::Program mask_;
  gl::Program edges_;
  gl::Program edgesOrBends_;
  gl::Program edgesOrBendsOfRadiance_;
  gl::Program shownEdgesOrDifference_;
  gl::Program shownEdgesOrDifferenceOfRadiance_;
  gl::Program edgesOrDifference_;
  gl::Program difference_;
  std::array<gl::RenderTarget, kMaxLevels - 1> zones_;
};

/// Puts the whole of the target bound into the zone, from which what is drawn next takes its pixels.
void startZone();

/// What is drawn next takes its pixels from the zone.
void drawOutOfZone();

/// Draws pass only in the zone, and leave the stencil as it is.
void drawInZone();

/// The same, into a target bound that is emptied: filter depth 0 marks what was not rendered, so that the
/// filter never reads it.
void clearAndDrawInZone();

}  // namespace mres
