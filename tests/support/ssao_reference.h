#pragma once

#include "effects/ssao/ssao.h"
#include "tests/support/hemisphere_reference.h"

namespace mres::test {

/// Accessibility of one pixel of the full resolution before any filter, in double precision: what
/// shaders/effects/ssao.glsl says, written anew. Background gives 1.
class SsaoReference {
 public:
  SsaoReference(const SyntheticGBuffer& gbuffer, const SsaoSettings& settings);
  [[nodiscard]] double accessibility(glm::ivec2 pixel) const;

 private:
  HemisphereReference hemisphere_;
  double intensity_;
};

}  // namespace mres::test
