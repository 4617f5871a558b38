// A small modelling kit for the built-in scenes: primitives append to a Mesh (smooth or faceted normals, uv in
// metres so that textures keep their scale, tangents), SceneBuilder collects meshes, materials and instances.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "host/scene/scene.h"

namespace host::modelling {

/// Axis-aligned box with outward faceted normals. `bevel` > 0 rounds the twelve edges (real edges catch light).
void addBox(Mesh& mesh, glm::vec3 min, glm::vec3 max, float bevel = 0.0f);

/// A rectangle origin, origin+u, origin+u+v, origin+v, tessellated; its normal is cross(u, v).
void addQuad(Mesh& mesh, glm::vec3 origin, glm::vec3 u, glm::vec3 v, glm::ivec2 segments = {1, 1});

/// Cylinder or cone frustum along +Y from `base`; capped where the radius is positive.
void addCylinder(Mesh& mesh, glm::vec3 base, float bottomRadius, float topRadius, float height, int segments);

/// Surface of revolution about +Y through `base`: profile points are (radius, height), bottom to top, outside to
/// the right. Edges of the profile sharper than `creaseDegrees` stay sharp.
void addLathe(Mesh& mesh, glm::vec3 base, std::span<const glm::vec2> profile, int segments,
              float creaseDegrees = 40.0f);

/// Sweeps a closed cross-section (counter-clockwise, in the plane of the path's normal frame) along a path.
void addSweep(Mesh& mesh, std::span<const glm::vec2> crossSection, std::span<const glm::vec3> path,
              bool closedPath = false, float creaseDegrees = 40.0f);

/// Extrudes a simple polygon (counter-clockwise in xy, may be concave) from z = 0 to z = depth.
void addExtrusion(Mesh& mesh, std::span<const glm::vec2> outline, float depth);

/// Ellipsoid.
void addEllipsoid(Mesh& mesh, glm::vec3 centre, glm::vec3 radii, glm::ivec2 segments);

/// A parametric patch with smooth normals: position(u, v) for u, v in 0..1.
void addPatch(Mesh& mesh, const std::function<glm::vec3(float, float)>& position, glm::ivec2 segments);

/// Applies `transform` to the vertices added since `firstVertex`.
void transformFrom(Mesh& mesh, std::size_t firstVertex, const glm::mat4& transform);

/// Collects a scene.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);
  int addMaterial(Material material);                ///< returns its index
  int addImage(Image image);                         ///< returns the index of a repeating texture of it
  int addMesh(Mesh mesh);                            ///< returns its index; the mesh names its material
  void place(int mesh, const glm::mat4& transform = glm::mat4(1.0f));
  Scene& scene() { return scene_; }
  Scene take() { return std::move(scene_); }

 private:
  Scene scene_;
};

}  // namespace host::modelling
