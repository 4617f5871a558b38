#pragma once

#include "host/scene/scene.h"

namespace host {

/// Where a mesh of an alpha-masked material has holes.
class AlphaMask {
 public:
  /// `scene` must outlive this, and the mesh's material be one of AlphaMode::mask.
  AlphaMask(const Scene& scene, const Mesh& mesh);

  /// Whether a triangle has a hole at barycentric coordinates (u, v): its second and third corner's.
  [[nodiscard]] bool isHole(unsigned triangle, float u, float v) const;

 private:
  [[nodiscard]] float alphaAt(glm::vec2 uv) const;
  [[nodiscard]] float texelAlpha(glm::ivec2 texel) const;

  const Mesh& mesh_;
  const Material& material_;
  const Texture* texture_ = nullptr;
  const Image* image_ = nullptr;
};

}  // namespace host
