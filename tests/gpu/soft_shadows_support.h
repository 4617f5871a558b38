// What the tests of soft shadows share.
#pragma once

#include <glm/glm.hpp>

#include "effects/soft_shadows/soft_shadows.h"
#include "mres/mres.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/synthetic_shadow.h"

namespace mres::test {

inline constexpr glm::ivec2 kSize{97, 73};
inline constexpr glm::ivec2 kMapSize{512, 512};

/// A floor a metre below the eye, seen from above.
RayCaster floorWithBox();

class SoftShadowsTest : public GlTest {
 protected:
  /// At full resolution.
  Image render(const RayCaster& scene, const SyntheticLight& light, const SoftShadowSettings& settings,
               glm::ivec2 size = kSize);

  MultiResolution multiResolution_;
  SoftShadows effect_;
};

}  // namespace mres::test
