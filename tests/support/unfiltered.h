#pragma once

#include <string>
#include <utility>

#include "mres/effect.h"

namespace mres::test {

/// An effect as its shader leaves it, without the filter of the levels.
template <class FilteredEffect>
class Unfiltered final : public Effect {
 public:
  template <class... Arguments>
  explicit Unfiltered(Arguments&&... arguments)
      : effect_(std::forward<Arguments>(arguments)...),
        name_(std::string("unfiltered ") + effect_.description().name),
        description_(effect_.description()) {
    description_.name = name_.c_str();
    description_.filtered = false;
  }

  FilteredEffect& effect() { return effect_; }
  [[nodiscard]] const EffectDescription& description() const override { return description_; }
  [[nodiscard]] const LevelTable& levels() const override { return effect_.levels(); }
  void setUp(const gl::Program& program) override { effect_.setUp(program); }
  void bind(const Frame& frame) override { effect_.bind(frame); }
  [[nodiscard]] glm::vec4 background() const override { return effect_.background(); }
  [[nodiscard]] std::size_t bytes() const override { return effect_.bytes(); }

 private:
  FilteredEffect effect_;
  std::string name_;
  EffectDescription description_;
};

}  // namespace mres::test
