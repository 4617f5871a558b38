#pragma once

#include <string>

#include "mres/plan/level_plan.h"
#include "tests/support/pictures.h"
#include "tests/support/test_effect.h"

namespace mres::test {

/// Values, 0..1, that differ between levels and between pixels.
double valueAt(glm::ivec2 fullPixel, int level);
/// The same in GLSL: `value`.
std::string valueInGlsl();

/// An effect of these values.
TestEffect::Recipe valueIn(const LevelTable& levels);

/// The full-resolution pixel at which a level's pixel is evaluated.
glm::ivec2 representative(glm::ivec2 pixel, int level, glm::ivec2 fullSize);

/// What a level that renders the whole screen shows of these values.
Image coarsestPicture(const PlannedLevel& level, glm::ivec2 fullSize);

/// A level's picture at a pixel of the full resolution.
double interpolated(const Image& picture, glm::ivec2 fullPixel, int level, glm::ivec2 fullSize);

}  // namespace mres::test
