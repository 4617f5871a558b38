#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace mres {

/// `count` points in the unit hemisphere around +Z: directions cosine-weighted, distances uniform, both
/// stratified.
std::vector<glm::vec3> hemispherePoints(int count, int seed);

/// The same as shaders/effects/common/hemisphere.glsl reads them: w is log2 of the distance.
std::vector<glm::vec4> hemispherePointsForShader(int count, int seed);

}  // namespace mres
