#pragma once

#include "effects/ssao/ssao.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {

/// Accessibility of one pixel of the full resolution before any filter, in double precision: what
/// shaders/effects/ssao.glsl says, written anew. Background gives 1.
class SsaoReference {
 public:
  SsaoReference(const SyntheticGBuffer& gbuffer, const SsaoSettings& settings);
  [[nodiscard]] double accessibility(glm::ivec2 pixel) const;

 private:
  [[nodiscard]] bool isBackground(glm::ivec2 pixel) const;
  [[nodiscard]] glm::dvec3 positionOf(glm::ivec2 pixel) const;
  [[nodiscard]] double occlusionOf(glm::dvec3 point, double log2Length, glm::dvec3 origin, glm::dvec3 normal,
                                   double originW) const;

  const SyntheticGBuffer& gbuffer_;
  SsaoSettings settings_;
  std::vector<glm::vec3> points_;
  glm::dmat4 projection_;
  glm::dmat4 inverseProjection_;
};

/// SSAO as its shader leaves it, without the filter of the levels.
class UnfilteredSsao final : public Effect {
 public:
  explicit UnfilteredSsao(const SsaoSettings& settings);
  [[nodiscard]] const EffectDescription& description() const override { return description_; }
  [[nodiscard]] const LevelTable& levels() const override { return ssao_.levels(); }
  void setUp(const gl::Program& program) override { ssao_.setUp(program); }
  void bind() override { ssao_.bind(); }

 private:
  Ssao ssao_;
  EffectDescription description_;
};

}  // namespace mres::test
