// Shapes that furniture is made of, beyond the primitives of the modelling kit.
#pragma once

#include <span>

#include "host/scene/builtin/modelling.h"

namespace host::furniture {

struct TubePoint {
  glm::vec3 position;
  float radius;
};

/// A round tube of varying radius along a smooth curve through `points`; open at both ends.
/// `segments` are around and along.
void addTube(Mesh& mesh, std::span<const TubePoint> points, glm::ivec2 segments);

/// The point at `t` in 0..1 of the Catmull-Rom spline through `points`, radius included.
TubePoint alongCurve(std::span<const TubePoint> points, float t);

enum class Ends { open, joined };

/// A moulding along `path`, mitred at its corners: `profile` points (away from the wall, up), bottom to top.
/// The room is to the left of the way along the path, seen from above.
void addMoulding(Mesh& mesh, std::span<const glm::vec2> profile, std::span<const glm::vec3> path, Ends ends);

/// A frame about the rectangle of `size` in the xy plane, centred, facing +Z; the points of its closed
/// cross-section are (way outwards from the rectangle, height), counter-clockwise.
void addFrame(Mesh& mesh, glm::vec2 size, std::span<const glm::vec2> section);

/// An upright prism over an outline of (x, z) points that runs from +X towards +Z.
void addPrism(Mesh& mesh, std::span<const glm::vec2> outline, float bottom, float height);

/// A flat board in the xz plane whose outline is a rounded rectangle, standing on y = bottom.
void addRoundedBoard(Mesh& mesh, glm::vec2 size, float cornerRadius, float bottom, float thickness,
                     int cornerSegments);

/// The point of a superellipsoid at u (around +Y) and v (from its bottom to its top): with exponents of 1 an
/// ellipsoid, towards 0 a box with ever less rounded sides (x: seen from above, y: seen from the side).
glm::vec3 superellipsoid(glm::vec3 radii, glm::vec2 exponents, float u, float v);

/// A cushion: a superellipsoid about `centre`.
void addCushion(Mesh& mesh, glm::vec3 centre, glm::vec3 radii, glm::vec2 exponents, glm::ivec2 segments);

/// A board in the xz plane between y = bottom and y = top with rounded corners and a rounded edge, for
/// tables.
void addTableTop(Mesh& mesh, glm::vec2 size, float cornerRadius, float bottom, float top, int cornerSegments);

/// A box with centre of its base at `base`.
void addBlock(Mesh& mesh, glm::vec3 base, glm::vec3 size, float bevel = 0.0f);

/// A straight round bar from `from` to `to`, capped.
void addRod(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radius, int segments);

/// Turns everything added since `firstVertex` that points along +Y into the direction of `axis`, then moves
/// it.
void aimFrom(Mesh& mesh, std::size_t firstVertex, glm::vec3 axis, glm::vec3 position);

}  // namespace host::furniture
