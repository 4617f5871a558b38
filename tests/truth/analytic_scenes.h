// Scenes whose light can be told by a formula.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/scene/scene.h"
#include "host/truth/grid_surfaces.h"

namespace host::test {

/// Corners in order around it; texture coordinates are (0, 0), (1, 0), (1, 1), (0, 1).
Mesh quad(const std::array<glm::vec3, 4>& corners, int material = -1);

/// A square of the plane y = height, `half` metres to each side of `centre`.
Mesh level(float height, glm::vec2 centre, float half, int material = -1);

/// Each mesh once, where it is.
Scene sceneOf(std::vector<Mesh> meshes);

/// Gives the scene a material with a texture of one row of texels with these alphas, not interpolated.
void addTexturedMaterial(Scene& scene, AlphaMode mode, const std::vector<std::uint8_t>& alphas);

/// One row of points that look up.
GridSurfaces pointsOnFloor(const std::vector<glm::vec3>& points);

}  // namespace host::test
