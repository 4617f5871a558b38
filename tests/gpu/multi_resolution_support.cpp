#include "tests/gpu/multi_resolution_support.h"

#include <utility>

#include "tests/support/test_effect.h"

namespace mres::test {

SsaoSettings ssaoWith(unsigned levels, int samples) {
  return {.samples = samples, .levels = levelSubset(levels)};
}

Picture MultiResolutionTest::full(Effect& effect, const Frame& frame) {
  const Technique technique = std::exchange(multiResolution_.settings().technique, Technique::full);
  Picture picture = renderPicture(multiResolution_, effect, frame);
  multiResolution_.settings().technique = technique;
  return picture;
}

Picture MultiResolutionTest::mixed(Effect& effect, const Frame& frame) {
  return renderPicture(multiResolution_, effect, frame);
}

}  // namespace mres::test
