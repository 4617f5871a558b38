#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "mres/mres.h"

namespace mres::test {

using Picture = std::vector<float>;

/// Lets edges alone decide what is refined, as the paper does.
void refineAtEveryEdge(MultiResolution& multiResolution);

/// Renders and reads the result, all its channels.
Picture renderPicture(MultiResolution& multiResolution, Effect& effect, const Frame& frame);

/// NaN and infinities count as infinitely far off.
double maxDifference(const Picture& a, const Picture& b);
double rootMeanSquare(const Picture& a, const Picture& b);
bool isFinite(const Picture& picture);

/// A perspective projection with near plane 0.1 m and far plane 100 m.
glm::mat4 perspective(glm::ivec2 size, float verticalDegrees = 60.0f);

}  // namespace mres::test
