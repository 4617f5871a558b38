#pragma once

#include <vector>

#include "host/scene/triangle_grid.h"

namespace host {

/// Number `i` in 0..1 of a low-discrepancy sequence: evenly spread, and the same in every run.
float radicalInverse(int base, int i);

/// Points on the surfaces with their normals. A triangle's weight is the root of its area: by area alone a
/// huge ground would get all points, by number alone a detailed plant would.
class SurfaceSampler {
 public:
  /// Of a grid that has triangles and outlives this.
  explicit SurfaceSampler(const TriangleGrid& grid);

  struct Sample {
    glm::vec3 position;
    glm::vec3 normal;
  };

  /// The same point for the same `i`; any number of them is spread evenly.
  [[nodiscard]] Sample sample(int i) const;

 private:
  const std::vector<WorldTriangle>& triangles_;
  std::vector<double> cumulativeWeights_;
};

}  // namespace host
