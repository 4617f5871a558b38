#pragma once

#include <array>
#include <string>

#include "effects/ssao/ssao.h"
#include "mres/effect.h"

namespace mres::test {

/// An effect whose shade() is given as GLSL: the body of `vec4 shade(Surface surface)`.
class TestEffect : public Effect {
 public:
  struct Recipe {
    std::string body;
    int channels = 1;
    bool filtered = false;
    LevelTable levels = kSsaoLevels;
    glm::vec4 background{1.0f};
    std::string name = "test";
    std::string preview = {};  ///< the body of `vec2 preview(Surface surface)`; empty: there is none
  };
  explicit TestEffect(Recipe recipe);

  [[nodiscard]] const EffectDescription& description() const override { return description_; }
  [[nodiscard]] const LevelTable& levels() const override { return recipe_.levels; }
  void setLevels(const LevelTable& levels) { recipe_.levels = levels; }
  void setUp(const gl::Program&) override {}
  void bind(const Frame&) override {}

 private:
  Recipe recipe_;
  std::string text_;
  std::array<gl::ShaderFile, 1> files_;
  EffectDescription description_;
};

/// Renders a quarter of each level's own number, so that the picture tells the levels apart.
TestEffect::Recipe levelNumbers(const LevelTable& levels = kSsaoLevels);

/// Table 1's levels of which bit i of `mask` says whether level i is used.
LevelTable levelSubset(unsigned mask);

}  // namespace mres::test
