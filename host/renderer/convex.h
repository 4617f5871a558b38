// Convex solids bounded by planes, as much of them as fitting a shadow map to what is seen needs.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/scene/scene.h"

namespace host {

/// Corners of a box or of a frustum: bit 0 of the index chooses x, bit 1 y, bit 2 z.
using Corners = std::array<glm::vec3, 8>;

Corners cornersOf(const Bounds& box);

/// The half-spaces dot(plane, (p, 1)) >= 0 that make up a box.
std::array<glm::vec4, 6> planesOf(const Bounds& box);

/// Points whose convex hull is the intersection of two such solids; empty if they don't meet.
std::vector<glm::vec3> intersectionPoints(const Corners& a, std::span<const glm::vec4> planesOfA,
                                          const Corners& b, std::span<const glm::vec4> planesOfB);

}  // namespace host
