#pragma once

#include <gtest/gtest.h>
#include <string>

#include "host/image/image_file.h"

namespace mres::test {

/// How much a picture may differ from its golden one: other versions of a driver round differently.
struct GoldenTolerance {
  float perChannel = 6.0f / 255.0f;  ///< a pixel fails if a channel differs by more
  double failingShare = 0.002;       ///< of the pixels may fail
};

/// Compares a picture with tests/golden/images/NAME.png. A failure leaves the picture and the difference in
/// the build folder. With MRES_UPDATE_GOLDEN=1 in the environment the golden picture is written instead.
testing::AssertionResult matchesGolden(const host::FloatImage& picture, const std::string& name,
                                       const GoldenTolerance& tolerance = {});

}  // namespace mres::test
