#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/truth/pixel_grid.h"
#include "mres/effect.h"

namespace host {

/// An effect as it comes out of its shader, unfiltered, at the pixels of a grid alone; elsewhere its values
/// are zero, and come for nearly nothing if the grid's tiles are the blocks of pixels that a device shades at
/// once.
class GridEffect final : public mres::Effect {
 public:
  GridEffect(std::unique_ptr<mres::Effect> effect, const PixelGrid& grid);

  [[nodiscard]] const mres::EffectDescription& description() const override { return description_; }
  [[nodiscard]] const mres::LevelTable& levels() const override { return effect_->levels(); }
  void setUp(const mres::gl::Program& program) override { effect_->setUp(program); }
  void bind(const mres::Frame& frame) override { effect_->bind(frame); }
  [[nodiscard]] glm::vec4 background() const override { return effect_->background(); }
  [[nodiscard]] std::size_t bytes() const override { return effect_->bytes(); }

 private:
  std::unique_ptr<mres::Effect> effect_;
  std::string shader_;
  std::vector<mres::gl::ShaderFile> files_;
  mres::EffectDescription description_;
};

}  // namespace host
