// What most primitives come down to: a grid of points with normals, turned into triangles with tangents.
#pragma once

#include <span>

#include "host/scene/scene.h"

namespace host::modelling {

struct GridPoint {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};
  glm::vec2 uv{0.0f};
};

/// Appends a grid whose points lie row by row, `columns` a row. It faces the side from which the columns run
/// to the right and the rows up. Triangles of coinciding corners, as at poles, are left out.
void addGrid(Mesh& mesh, std::span<const GridPoint> points, int columns);

/// Appends a flat convex polygon, counter-clockwise, smooth where the normals say so; its texture runs along
/// `right`.
void addFacet(Mesh& mesh, std::span<const GridPoint> corners, glm::vec3 right);

/// The part of `direction` orthogonal to `normal`, unit length, or any orthogonal unit vector when there is
/// none.
glm::vec3 tangentAlong(glm::vec3 direction, glm::vec3 normal);

}  // namespace host::modelling
