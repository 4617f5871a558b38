// Ray casting on the CPU, for questions about a scene's space such as "what does one see from here?".
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "host/scene/scene.h"

namespace host {

struct RayHit {
  float distance = 0.0f;
  glm::vec3 normal{0.0f};   ///< unit length, towards the ray's origin
  bool isBackFace = false;  ///< of a single-sided surface: the origin is inside of something solid
};

struct WorldTriangle {
  std::array<glm::vec3, 3> corners;
  bool isDoubleSided = false;
};

/// A uniform grid of cells, each with the triangles that its box touches. Very large scenes are thinned out.
class TriangleGrid {
 public:
  explicit TriangleGrid(const Scene& scene);

  /// The nearest surface along the ray; `direction` is unit length.
  [[nodiscard]] std::optional<RayHit> trace(glm::vec3 origin, glm::vec3 direction) const;

  [[nodiscard]] const std::vector<WorldTriangle>& triangles() const { return triangles_; }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  struct CellRange {
    glm::ivec3 first;
    glm::ivec3 last;
  };

  void chooseResolution();
  void fillCells();
  [[nodiscard]] std::size_t referenceCount() const;
  [[nodiscard]] CellRange cellsOf(const WorldTriangle& triangle) const;
  [[nodiscard]] std::size_t cellIndex(glm::ivec3 cell) const;
  template <typename Visit>
  void visitCells(const WorldTriangle& triangle, Visit visit) const;

  std::vector<WorldTriangle> triangles_;
  Bounds bounds_;
  glm::ivec3 resolution_{1};
  glm::vec3 cellSize_{1.0f};
  std::vector<std::uint32_t> cellStarts_;  ///< one for each cell and one more: ranges of cellTriangles_
  std::vector<std::uint32_t> cellTriangles_;
};

}  // namespace host
