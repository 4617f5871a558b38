#include "host/scene/builtin/surface_grid.h"

#include <algorithm>

namespace host::modelling {
namespace {

constexpr float kCoincident = 1e-6f;  // metres

bool coincide(const Vertex& a, const Vertex& b) {
  return glm::distance(a.position, b.position) < kCoincident;
}

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vertex& va = mesh.vertices[a];
  const Vertex& vb = mesh.vertices[b];
  const Vertex& vc = mesh.vertices[c];
  if (coincide(va, vb) || coincide(vb, vc) || coincide(vc, va)) return;
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// The direction in which the columns run at a point; at a pole, that of the row beside it.
glm::vec3 columnDirection(std::span<const GridPoint> points, int columns, int row, int column) {
  const int rows = static_cast<int>(points.size()) / columns;
  const int left = std::max(column - 1, 0);
  const int right = std::min(column + 1, columns - 1);
  for (const int nearRow : {row, std::max(row - 1, 0), std::min(row + 1, rows - 1)}) {
    const glm::vec3 along =
        points[nearRow * columns + right].position - points[nearRow * columns + left].position;
    if (glm::length(along) > kCoincident) return along;
  }
  return {1.0f, 0.0f, 0.0f};
}

}  // namespace

glm::vec3 tangentAlong(glm::vec3 direction, glm::vec3 normal) {
  const glm::vec3 flat = direction - normal * glm::dot(direction, normal);
  if (glm::length(flat) > 1e-3f * glm::length(direction)) return glm::normalize(flat);
  const glm::vec3 other = std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(other - normal * glm::dot(other, normal));
}

void addGrid(Mesh& mesh, std::span<const GridPoint> points, int columns) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const int rows = static_cast<int>(points.size()) / columns;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const GridPoint& point = points[row * columns + column];
      const glm::vec3 tangent = tangentAlong(columnDirection(points, columns, row, column), point.normal);
      mesh.vertices.push_back({point.position, point.normal, glm::vec4(tangent, 1.0f), point.uv});
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const std::uint32_t lowerLeft = base + static_cast<std::uint32_t>(row * columns + column);
      const std::uint32_t upperLeft = lowerLeft + static_cast<std::uint32_t>(columns);
      addTriangle(mesh, lowerLeft, lowerLeft + 1, upperLeft + 1);
      addTriangle(mesh, lowerLeft, upperLeft + 1, upperLeft);
    }
  }
}

void addFacet(Mesh& mesh, std::span<const GridPoint> corners, glm::vec3 right) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const GridPoint& corner : corners) {
    const glm::vec3 tangent = tangentAlong(right, corner.normal);
    mesh.vertices.push_back({corner.position, corner.normal, glm::vec4(tangent, 1.0f), corner.uv});
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i) addTriangle(mesh, base, base + i - 1, base + i);
}

}  // namespace host::modelling
