#pragma once

#include <vector>

#include "host/peers/level_block.h"
#include "mres/gl/render_target.h"

namespace host {

/// What a level renders into of which some tiles are rendered and the rest comes from the coarser level.
class TiledLevel {
 public:
  explicit TiledLevel(int index) : index_(index) {}

  /// Makes the targets unless they have the frame's size, all or none, and binds the level's block.
  void prepare(const PeerFrame& frame);

  [[nodiscard]] int index() const { return index_; }
  [[nodiscard]] glm::ivec2 size() const { return picture().size(); }
  [[nodiscard]] const mres::gl::RenderTarget& raw() const { return targets_.raw; }
  [[nodiscard]] const mres::gl::RenderTarget& filteredAlongX() const { return targets_.filteredAlongX; }
  /// With filter depth where a finer level follows.
  [[nodiscard]] const mres::gl::RenderTarget& picture() const { return targets_.picture; }
  [[nodiscard]] std::vector<const mres::gl::RenderTarget*> targets() const {
    return {&raw(), &filteredAlongX(), &picture()};
  }
  [[nodiscard]] std::size_t stencilBytes() const { return targets_.stencil.bytes(); }

 private:
  struct Targets {
    mres::gl::StencilBuffer stencil;
    mres::gl::RenderTarget raw;
    mres::gl::RenderTarget filteredAlongX;
    mres::gl::RenderTarget picture;
  };
  [[nodiscard]] Targets make(const mres::EffectDescription& effect, glm::ivec2 size) const;

  int index_;
  LevelBlock block_;
  Targets targets_;
};

}  // namespace host
