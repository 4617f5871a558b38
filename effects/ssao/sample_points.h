#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace mres {

/// `count` points in the unit hemisphere around +Z: directions cosine-weighted, distances uniform, both
/// stratified.
std::vector<glm::vec3> hemispherePoints(int count, int seed);

}  // namespace mres
