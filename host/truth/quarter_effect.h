#pragma once

#include <memory>

#include "mres/effect.h"

namespace host {

/// An effect as it comes out of its shader, unfiltered, on the levels 0 and 2 alone. With a zone of level 0
/// that is empty, just the pixels of the quarter level are evaluated: a sixteenth of the picture's.
class QuarterEffect final : public mres::Effect {
 public:
  explicit QuarterEffect(std::unique_ptr<mres::Effect> effect);

  [[nodiscard]] const mres::EffectDescription& description() const override { return description_; }
  [[nodiscard]] const mres::LevelTable& levels() const override;
  void setUp(const mres::gl::Program& program) override { effect_->setUp(program); }
  void bind(const mres::Frame& frame) override { effect_->bind(frame); }

 private:
  std::unique_ptr<mres::Effect> effect_;
  mres::EffectDescription description_;
};

}  // namespace host
