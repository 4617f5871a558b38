#pragma once

#include <memory>
#include <span>

#include "host/scene/scene.h"

namespace host {

/// The surfaces of a scene that hide and shade others, for rays, by Embree. As in the renderer's shadow map,
/// both sides of them do, alpha-masked ones have holes, and alpha-blended ones do nothing. Any number of
/// threads may ask at once.
class RayScene {
 public:
  /// `scene` must outlive this. Throws std::runtime_error with a sentence if Embree fails, e.g. for want of
  /// memory.
  explicit RayScene(const Scene& scene);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;
  RayScene(RayScene&&) = delete;
  RayScene& operator=(RayScene&&) = delete;

  /// On how many of the segments from `origin` to origin + segment a surface lies. World space, metres; no
  /// segment may be zero.
  [[nodiscard]] int countBlocked(glm::vec3 origin, std::span<const glm::vec3> segments) const;

  /// Metres; no two points of the scene are further apart.
  [[nodiscard]] float diameter() const { return diameter_; }

 private:
  struct Geometry;

  std::unique_ptr<Geometry> geometry_;  // keeps Embree out of users' files
  float diameter_ = 0.0f;
};

}  // namespace host
