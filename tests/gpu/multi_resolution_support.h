// What the tests of the facade share.
#pragma once

#include <limits>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"

namespace mres::test {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Bit i of `levels` says whether level i is used.
SsaoSettings ssaoWith(unsigned levels, int samples = 8);

class MultiResolutionTest : public GlTest {
 protected:
  /// At full resolution.
  Picture full(Effect& effect, const Frame& frame);
  Picture mixed(Effect& effect, const Frame& frame);

  MultiResolution multiResolution_;
};

}  // namespace mres::test
