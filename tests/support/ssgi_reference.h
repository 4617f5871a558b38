#pragma once

#include <functional>

#include "effects/ssgi/ssgi.h"
#include "tests/support/hemisphere_reference.h"

namespace mres::test {

/// A lit picture (RGBA32F) of a colour for each pixel, and its values.
struct LitPicture {
  LitPicture(glm::ivec2 size, const std::function<glm::vec3(glm::ivec2 pixel)>& colourOf);

  glm::ivec2 size;
  std::vector<glm::vec4> texels;
  gl::Texture2D texture;
};

LitPicture uniformPicture(glm::ivec2 size, glm::vec3 colour);

/// A lit picture in which every surface that faces `direction` has the colour `there`.
LitPicture facingPicture(const SyntheticGBuffer& gbuffer, glm::vec3 direction, glm::vec3 there,
                         glm::vec3 elsewhere);

/// Radiance that arrives at one pixel of the full resolution before any filter, in double precision: what
/// shaders/effects/ssgi.glsl and ssgi_senders.frag say, written anew. Background gives the mean of what comes
/// from above and from below.
class SsgiReference {
 public:
  SsgiReference(const SyntheticGBuffer& gbuffer, const LitPicture& lit, const SsgiSettings& settings,
                const SsgiInputs& inputs);
  [[nodiscard]] glm::dvec3 arriving(glm::ivec2 pixel) const;

 private:
  [[nodiscard]] glm::dvec3 environment(glm::dvec3 direction) const;
  [[nodiscard]] glm::dvec3 sanitised(glm::ivec2 pixel) const;
  /// Of the surfaces in a texel of a mip of depth that face as its own pixel's does.
  [[nodiscard]] glm::dvec3 meanSent(glm::ivec2 texel, int mip) const;
  [[nodiscard]] glm::dvec3 sentBy(const Sight& sender) const;

  HemisphereReference hemisphere_;
  const LitPicture& lit_;
  SsgiSettings settings_;
  SsgiInputs inputs_;
};

}  // namespace mres::test
