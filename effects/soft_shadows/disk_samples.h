#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace mres {

/// `count` points spread evenly over the unit disk, on a spiral of the golden angle (Vogel 1979, "A better
/// way to construct the sunflower head"). `seed` turns the spiral.
std::vector<glm::vec2> diskSamples(int count, int seed);

/// The same, with the outermost ones on the rim.
std::vector<glm::vec2> diskSamplesToTheRim(int count, int seed);

}  // namespace mres
