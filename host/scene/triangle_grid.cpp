#include "host/scene/triangle_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kMaxTriangles = 4'000'000;  // some 200 MB
constexpr int kMaxResolution = 400;
constexpr double kCellsPerTriangle = 8.0;

std::vector<WorldTriangle> worldTriangles(const Scene& scene) {
  const std::size_t step = triangleCount(scene) / kMaxTriangles + 1;
  std::vector<WorldTriangle> triangles;
  triangles.reserve(triangleCount(scene) / step + scene.instances.size());
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    const bool isMirrored = glm::determinant(glm::mat3(instance.transform)) < 0.0f;
    const bool isDoubleSided = mesh.material >= 0 && scene.materials[std::size_t(mesh.material)].doubleSided;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3 * step) {
      WorldTriangle triangle{{}, isDoubleSided};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec3 position = mesh.vertices[mesh.indices[i + corner]].position;
        triangle.corners[corner] = glm::vec3(instance.transform * glm::vec4(position, 1.0f));
      }
      if (isMirrored) std::swap(triangle.corners[1], triangle.corners[2]);
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// Möller and Trumbore, "Fast, minimum storage ray/triangle intersection", 1997. Infinity where the ray
/// misses.
float intersect(const WorldTriangle& triangle, glm::vec3 origin, glm::vec3 direction) {
  const glm::vec3 edge1 = triangle.corners[1] - triangle.corners[0];
  const glm::vec3 edge2 = triangle.corners[2] - triangle.corners[0];
  const glm::vec3 p = glm::cross(direction, edge2);
  const float determinant = glm::dot(edge1, p);
  if (determinant == 0.0f) return kInfinity;
  const glm::vec3 toOrigin = origin - triangle.corners[0];
  const float u = glm::dot(toOrigin, p) / determinant;
  const glm::vec3 q = glm::cross(toOrigin, edge1);
  const float v = glm::dot(direction, q) / determinant;
  const float distance = glm::dot(edge2, q) / determinant;
  const bool isHit = u >= 0.0f && v >= 0.0f && u + v <= 1.0f && distance > 0.0f;
  return isHit ? distance : kInfinity;
}

RayHit hitOf(const WorldTriangle& triangle, float distance, glm::vec3 direction) {
  const glm::dvec3 edge1 = triangle.corners[1] - triangle.corners[0];
  const glm::dvec3 edge2 = triangle.corners[2] - triangle.corners[0];
  const glm::vec3 normal(glm::normalize(glm::cross(edge1, edge2)));
  const bool isBehind = glm::dot(normal, direction) > 0.0f;
  return {distance, isBehind ? -normal : normal, isBehind && !triangle.isDoubleSided};
}

/// The part of the ray that is within the box; empty (first > second) where it misses.
std::pair<float, float> clipToBox(glm::vec3 origin, glm::vec3 direction, const Bounds& box) {
  float enter = 0.0f;
  float leave = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0f) {
      if (origin[axis] < box.min[axis] || origin[axis] > box.max[axis]) return {1.0f, 0.0f};
      continue;
    }
    const float a = (box.min[axis] - origin[axis]) / direction[axis];
    const float b = (box.max[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

}  // namespace

TriangleGrid::TriangleGrid(const Scene& scene) : triangles_(worldTriangles(scene)), bounds_(boundsOf(scene)) {
  const glm::vec3 size = bounds_.max - bounds_.min;
  // Flat scenes need some thickness, and rounding must not lose what lies on the boundary.
  const glm::vec3 margin(std::max(1e-4f * std::max({size.x, size.y, size.z}), 1e-20f));
  bounds_.min -= margin;
  bounds_.max += margin;
  chooseResolution();
  fillCells();
}

/// A few cells for each triangle, of about cubic shape; fewer where large triangles would fill too many.
void TriangleGrid::chooseResolution() {
  const glm::vec3 size = bounds_.max - bounds_.min;
  const double volume = double(size.x) * size.y * size.z;
  float edge =
      float(std::cbrt(volume / (kCellsPerTriangle * double(std::max<std::size_t>(triangles_.size(), 1)))));
  do {
    for (int axis = 0; axis < 3; ++axis) {
      resolution_[axis] =
          std::clamp(int(std::min(size[axis] / edge, float(kMaxResolution))), 1, kMaxResolution);
    }
    cellSize_ = size / glm::vec3(resolution_);
    edge *= 1.5f;
  } while (resolution_ != glm::ivec3(1) && referenceCount() > 16 * triangles_.size() + 100'000);
}

TriangleGrid::CellRange TriangleGrid::cellsOf(const WorldTriangle& triangle) const {
  const auto& [a, b, c] = triangle.corners;
  const glm::vec3 low = (glm::min(a, glm::min(b, c)) - bounds_.min) / cellSize_;
  const glm::vec3 high = (glm::max(a, glm::max(b, c)) - bounds_.min) / cellSize_;
  return {glm::clamp(glm::ivec3(low), glm::ivec3(0), resolution_ - 1),
          glm::clamp(glm::ivec3(high), glm::ivec3(0), resolution_ - 1)};
}

std::size_t TriangleGrid::referenceCount() const {
  std::size_t count = 0;
  for (const WorldTriangle& triangle : triangles_) {
    const CellRange range = cellsOf(triangle);
    const glm::ivec3 size = range.last - range.first + 1;
    count += std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
  }
  return count;
}

std::size_t TriangleGrid::cellIndex(glm::ivec3 cell) const {
  return (std::size_t(cell.z) * std::size_t(resolution_.y) + std::size_t(cell.y)) *
             std::size_t(resolution_.x) +
         std::size_t(cell.x);
}

template <typename Visit>
void TriangleGrid::visitCells(const WorldTriangle& triangle, Visit visit) const {
  const auto [first, last] = cellsOf(triangle);
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) visit(cellIndex({x, y, z}));
    }
  }
}

/// Counts, sums up, and then fills from the end of each cell's range downwards.
void TriangleGrid::fillCells() {
  cellStarts_.assign(cellIndex(resolution_ - 1) + 2, 0);
  for (const WorldTriangle& triangle : triangles_) {
    visitCells(triangle, [this](std::size_t cell) { ++cellStarts_[cell]; });
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : cellStarts_) start = sum += start;
  cellTriangles_.resize(sum);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    visitCells(triangles_[i],
               [this, i](std::size_t cell) { cellTriangles_[--cellStarts_[cell]] = std::uint32_t(i); });
  }
}

/// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987.
std::optional<RayHit> TriangleGrid::trace(glm::vec3 origin, glm::vec3 direction) const {
  const auto [enter, leave] = clipToBox(origin, direction, bounds_);
  if (enter > leave) return std::nullopt;
  const glm::vec3 start = (origin + direction * enter - bounds_.min) / cellSize_;
  glm::ivec3 cell = glm::clamp(glm::ivec3(start), glm::ivec3(0), resolution_ - 1);
  glm::ivec3 step(0);
  glm::vec3 next(kInfinity);   // distance at which the ray leaves the cell, along each axis
  glm::vec3 delta(kInfinity);  // distance between two walls
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0f) continue;
    step[axis] = direction[axis] > 0.0f ? 1 : -1;
    delta[axis] = cellSize_[axis] / std::abs(direction[axis]);
    const auto wall = float(cell[axis] + (step[axis] > 0 ? 1 : 0));
    next[axis] = (bounds_.min[axis] + wall * cellSize_[axis] - origin[axis]) / direction[axis];
  }

  float nearest = kInfinity;
  std::uint32_t nearestTriangle = 0;
  while (true) {
    const std::size_t index = cellIndex(cell);
    for (std::uint32_t i = cellStarts_[index]; i < cellStarts_[index + 1]; ++i) {
      const float distance = intersect(triangles_[cellTriangles_[i]], origin, direction);
      if (distance >= nearest) continue;
      nearest = distance;
      nearestTriangle = cellTriangles_[i];
    }
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    if (nearest <= next[axis]) return hitOf(triangles_[nearestTriangle], nearest, direction);
    cell[axis] += step[axis];
    if (cell[axis] < 0 || cell[axis] >= resolution_[axis]) break;
    next[axis] += delta[axis];
  }
  if (nearest == kInfinity) return std::nullopt;
  return hitOf(triangles_[nearestTriangle], nearest, direction);
}

}  // namespace host
