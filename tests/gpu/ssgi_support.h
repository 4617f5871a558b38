// What the tests of SSGI share.
#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "effects/ssgi/ssgi.h"
#include "mres/mres.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr glm::vec3 kWhite(1.0f);

class SsgiTest : public GlTest {
 protected:
  Image render(const SyntheticGBuffer& gbuffer, const SsgiSettings& settings, const SsgiInputs& inputs,
               Technique technique = Technique::full) {
    multiResolution_.settings().technique = technique;
    ssgi_.setSettings(settings);
    ssgi_.setInputs(inputs);
    return {gbuffer.frame().size, 3, renderPicture(multiResolution_, ssgi_, gbuffer.frame())};
  }

  MultiResolution multiResolution_;
  Ssgi ssgi_;
};

}  // namespace mres::test
