#pragma once

#include "host/scene/scene.h"
#include "host/scene/triangle_grid.h"

namespace host {

/// How good a picture a camera would take: 0 for one that sees next to nothing, is inside of something solid
/// or has its nose against a wall; about 1 for a filled frame with much shape, near and far. `reach` is a
/// distance that counts as far in this scene.
float viewScore(const TriangleGrid& grid, const Camera& camera, float reach);

}  // namespace host
