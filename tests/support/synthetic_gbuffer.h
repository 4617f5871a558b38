#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "mres/frame.h"
#include "mres/gl/texture.h"

namespace mres::test {

/// What a camera ray meets: distance along -Z in view space and the view-space normal.
struct Hit {
  double viewDepth = 0.0;
  glm::dvec3 normal{0.0};
};

/// The scene of a synthetic G-buffer: a view-space ray (origin, direction with z = -1) to what it meets; nothing is
/// background.
using RayCaster = std::function<std::optional<Hit>(glm::dvec3 origin, glm::dvec3 direction)>;

/// Depth (32-bit float) and view-space normals (RGBA16F) of a scene that is cast in double precision, and the
/// frame that hands them to mres.
class SyntheticGBuffer {
 public:
  SyntheticGBuffer(glm::ivec2 size, const glm::mat4& projection, const RayCaster& scene);
  [[nodiscard]] const Frame& frame() const { return frame_; }

 private:
  gl::Texture2D depth_;
  gl::Texture2D normals_;
  Frame frame_;
};

/// dot(normal, x) = offset.
RayCaster plane(glm::dvec3 normal, double offset);

/// The nearest of several.
RayCaster nearest(std::vector<RayCaster> scenes);

RayCaster sphere(glm::dvec3 centre, double radius);

/// Seen from outside or inside.
RayCaster box(glm::dvec3 min, glm::dvec3 max);

/// A floor, walls, and many boxes and spheres: a room with every kind of edge, filling the picture.
RayCaster room();

}  // namespace mres::test
