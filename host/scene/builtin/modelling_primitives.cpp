#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/modelling.h"
#include "host/scene/builtin/surface_grid.h"

namespace host::modelling {
namespace {

/// A side of a box seen from outside: right and up of its texture, and its outward normal.
struct Side {
  glm::vec3 right, up, normal;
};

constexpr std::array<Side, 6> kSides{{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
                                      {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
                                      {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                      {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                      {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}};

/// A box as its centre and half size, with corners pulled in by the bevel.
struct BevelledBox {
  glm::vec3 centre, half;
  float bevel;

  /// The corner of octant `sign` on the face of `normal`.
  [[nodiscard]] glm::vec3 corner(glm::vec3 sign, glm::vec3 normal) const {
    const glm::vec3 inset = bevel * (glm::vec3(1.0f) - glm::abs(normal));
    return centre + sign * (half - inset);
  }
};

GridPoint mapped(const Side& side, glm::vec3 position, glm::vec3 normal) {
  return {position, normal, {glm::dot(position, side.right), -glm::dot(position, side.up)}};
}

void addFace(Mesh& mesh, const BevelledBox& box, const Side& side) {
  std::array<GridPoint, 4> corners;
  constexpr std::array<glm::vec2, 4> kTurn{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec3 sign = side.normal + kTurn[i].x * side.right + kTurn[i].y * side.up;
    corners[i] = mapped(side, box.corner(sign, side.normal), side.normal);
  }
  addFacet(mesh, corners, side.right);
}

/// The chamfer between `side` and the face of `other`.
void addEdge(Mesh& mesh, const BevelledBox& box, const Side& side, glm::vec3 other) {
  const glm::vec3 along = glm::cross(side.normal, other);
  const glm::vec3 out = side.normal + other;
  const std::array<GridPoint, 4> corners{mapped(side, box.corner(out + along, side.normal), side.normal),
                                         mapped(side, box.corner(out - along, side.normal), side.normal),
                                         mapped(side, box.corner(out - along, other), other),
                                         mapped(side, box.corner(out + along, other), other)};
  addFacet(mesh, corners, tangentAlong(side.right, glm::normalize(out)));
}

void addCorner(Mesh& mesh, const BevelledBox& box, glm::vec3 sign) {
  const glm::vec3 x(sign.x, 0, 0);
  const glm::vec3 y(0, sign.y, 0);
  const glm::vec3 z(0, 0, sign.z);
  const Side& side = kSides[sign.x > 0.0f ? 0 : 1];
  std::array<GridPoint, 3> corners{mapped(side, box.corner(sign, x), x), mapped(side, box.corner(sign, y), y),
                                   mapped(side, box.corner(sign, z), z)};
  if (sign.x * sign.y * sign.z < 0.0f) std::swap(corners[1], corners[2]);
  addFacet(mesh, corners, tangentAlong(side.right, glm::normalize(sign)));
}

void addBevels(Mesh& mesh, const BevelledBox& box) {
  for (const std::size_t i : {0, 1}) {  // the edges of the faces +x and -x
    for (const std::size_t j : {2, 3, 4, 5}) addEdge(mesh, box, kSides[i], kSides[j].normal);
  }
  for (const std::size_t i : {2, 3}) {  // those between +-y and +-z
    for (const std::size_t j : {4, 5}) addEdge(mesh, box, kSides[i], kSides[j].normal);
  }
  for (int octant = 0; octant < 8; ++octant) {
    addCorner(mesh, box,
              {(octant & 1) != 0 ? 1.0f : -1.0f, (octant & 2) != 0 ? 1.0f : -1.0f,
               (octant & 4) != 0 ? 1.0f : -1.0f});
  }
}

}  // namespace

void addBox(Mesh& mesh, glm::vec3 min, glm::vec3 max, float bevel) {
  const glm::vec3 size = max - min;
  const float widest = 0.45f * std::min({size.x, size.y, size.z});  // opposite chamfers must not meet
  const BevelledBox box{0.5f * (min + max), 0.5f * size, std::min(bevel, widest)};
  for (const Side& side : kSides) addFace(mesh, box, side);
  if (bevel > 0.0f) addBevels(mesh, box);
}

void addQuad(Mesh& mesh, glm::vec3 origin, glm::vec3 u, glm::vec3 v, glm::ivec2 segments) {
  const glm::vec3 normal = glm::normalize(glm::cross(u, v));
  const glm::vec2 size(glm::length(u), glm::length(v));
  std::vector<GridPoint> points;
  for (int row = 0; row <= segments.y; ++row) {
    for (int column = 0; column <= segments.x; ++column) {
      const glm::vec2 at = glm::vec2(column, row) / glm::vec2(segments);
      points.push_back({origin + at.x * u + at.y * v, normal, {at.x * size.x, (1.0f - at.y) * size.y}});
    }
  }
  addGrid(mesh, points, segments.x + 1);
}

void addCylinder(Mesh& mesh, glm::vec3 base, float bottomRadius, float topRadius, float height,
                 int segments) {
  const std::array<glm::vec2, 4> profile{
      {{0.0f, 0.0f}, {bottomRadius, 0.0f}, {topRadius, height}, {0.0f, height}}};
  addLathe(mesh, base, profile, segments);
}

void addEllipsoid(Mesh& mesh, glm::vec3 centre, glm::vec3 radii, glm::ivec2 segments) {
  const float around = glm::two_pi<float>() * std::max(radii.x, radii.z);
  const float poleToPole = glm::pi<float>() * radii.y;
  std::vector<GridPoint> points;
  for (int row = 0; row <= segments.y; ++row) {
    const float up = static_cast<float>(row) / static_cast<float>(segments.y);
    const float latitude = (up - 0.5f) * glm::pi<float>();
    const bool pole = row == 0 || row == segments.y;
    const float ring = pole ? 0.0f : std::cos(latitude);
    for (int column = 0; column <= segments.x; ++column) {
      const float turn = static_cast<float>(column) / static_cast<float>(segments.x);
      const float angle =
          glm::two_pi<float>() * static_cast<float>(column % segments.x) / static_cast<float>(segments.x);
      const glm::vec3 unit(ring * std::cos(angle), std::sin(latitude), -ring * std::sin(angle));
      points.push_back(
          {centre + radii * unit, glm::normalize(unit / radii), {turn * around, (1.0f - up) * poleToPole}});
    }
  }
  addGrid(mesh, points, segments.x + 1);
}

}  // namespace host::modelling
