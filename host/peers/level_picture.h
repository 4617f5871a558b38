#pragma once

#include <vector>

#include "host/peers/filter_pass.h"
#include "host/peers/level_block.h"

namespace host {

/// The effect at every pixel of one level, filtered, with filter depth.
class LevelPicture {
 public:
  explicit LevelPicture(int index) : index_(index) {}

  /// Leaves the level's block bound.
  void draw(const PeerFrame& frame, const FilterPass& filter);

  [[nodiscard]] int index() const { return index_; }
  [[nodiscard]] glm::ivec2 size() const { return picture_.size(); }
  [[nodiscard]] const mres::gl::Texture2D& color() const { return picture_.color(); }
  [[nodiscard]] std::vector<const mres::gl::RenderTarget*> targets() const {
    return {&picture_, &filteredAlongX_};
  }

 private:
  int index_;
  LevelBlock block_;
  mres::gl::RenderTarget picture_;  // before the filter, too
  mres::gl::RenderTarget filteredAlongX_;
};

}  // namespace host
