#pragma once

#include <vector>

#include "host/renderer/camera_view.h"
#include "host/renderer/scene/draw_list.h"
#include "host/renderer/scene/material_store.h"

namespace host {

/// The scene's instances with their bounds, grouped so that one material is bound once and one mesh drawn
/// once.
class InstanceSet {
 public:
  InstanceSet(const Scene& scene, const GeometryStore& geometry, const MaterialStore& materials);

  /// Opaque and alpha-masked instances that may be seen; `frustum` is relative to `origin`.
  [[nodiscard]] DrawList opaque(const Frustum& frustum, glm::vec3 origin) const;
  /// Alpha-blended instances that may be seen, from back to front.
  [[nodiscard]] DrawList blended(const CameraView& view) const;

  [[nodiscard]] bool hasBlended() const { return !blended_.empty(); }
  /// Of everything that is drawn; a unit cube if that is nothing.
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  struct Placed {
    int mesh = 0;
    int material = 0;
    bool mirrored = false;
    glm::mat4 transform{1.0f};
    Bounds bounds;  // in the world
  };
  static InstanceData relative(const Placed& instance, glm::vec3 origin);
  static void appendCommand(DrawList& list, const Placed& instance, glm::vec3 origin);

  std::vector<Placed> opaque_;  // sorted by material, then mesh, then orientation
  std::vector<Placed> blended_;
  Bounds bounds_{glm::vec3(-0.5f), glm::vec3(0.5f)};
};

}  // namespace host
