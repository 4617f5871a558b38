// A small modelling kit for the built-in scenes: primitives append to a Mesh (smooth or faceted normals, uv
// in metres so that textures keep their scale, tangents), SceneBuilder collects meshes, materials and
// instances.
//
// Every primitive faces outwards, counter-clockwise, and maps textures upright: u runs to the right and v
// down as seen from the front, so the handedness of every tangent is +1 until something mirrors it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/scene/scene.h"

namespace host::modelling {

/// Axis-aligned box with outward faceted normals; uv are the mesh's coordinates, so neighbouring boxes
/// continue one texture. `bevel` > 0 chamfers the edges and shades the chamfers as if rounded (real edges
/// catch light): 44 triangles instead of 12.
void addBox(Mesh& mesh, glm::vec3 min, glm::vec3 max, float bevel = 0.0f);

/// A rectangle origin, origin+u, origin+u+v, origin+v, tessellated; its normal is cross(u, v). The texture's
/// top is at origin+v.
void addQuad(Mesh& mesh, glm::vec3 origin, glm::vec3 u, glm::vec3 v, glm::ivec2 segments = {1, 1});

/// Cylinder or cone frustum along +Y from `base`; capped where the radius is positive.
void addCylinder(Mesh& mesh, glm::vec3 base, float bottomRadius, float topRadius, float height, int segments);

/// Surface of revolution about +Y through `base`: profile points are (radius, height), bottom to top, outside
/// to the right. Edges of the profile sharper than `creaseDegrees` stay sharp. Watertight where the profile
/// starts and ends on the axis; open otherwise.
void addLathe(Mesh& mesh, glm::vec3 base, std::span<const glm::vec2> profile, int segments,
              float creaseDegrees = 40.0f);

/// Sweeps a closed cross-section along a path: x points right and y up as seen by someone who walks along the
/// path, counter-clockwise. `up` fixes the frame at the start; it is carried along without twist. Corners are
/// mitred, and sharp above `creaseDegrees`, as are those of the cross-section. Open paths are capped; closed
/// ones (the first point not repeated) must be planar. u runs along the path.
void addSweep(Mesh& mesh, std::span<const glm::vec2> crossSection, std::span<const glm::vec3> path,
              bool closedPath = false, float creaseDegrees = 40.0f, glm::vec3 up = {0.0f, 1.0f, 0.0f});

/// Extrudes a simple polygon (counter-clockwise in xy, may be concave) from z = 0 to z = depth. Corners of
/// the outline sharper than `creaseDegrees` stay sharp.
void addExtrusion(Mesh& mesh, std::span<const glm::vec2> outline, float depth, float creaseDegrees = 40.0f);

/// Ellipsoid; segments are around +Y and from pole to pole.
void addEllipsoid(Mesh& mesh, glm::vec3 centre, glm::vec3 radii, glm::ivec2 segments);

/// A parametric patch with smooth normals: position(u, v) for u, v in 0..1. It faces the side from which u
/// runs to the right and v up; edges may collapse to a point.
void addPatch(Mesh& mesh, const std::function<glm::vec3(float, float)>& position, glm::ivec2 segments);

/// Appends a copy of `part`, transformed; its material is ignored.
void addMesh(Mesh& mesh, const Mesh& part, const glm::mat4& transform = glm::mat4(1.0f));

/// Applies `transform` to the vertices added since `firstVertex`; mirroring transforms keep the faces
/// outward.
void transformFrom(Mesh& mesh, std::size_t firstVertex, const glm::mat4& transform);

/// Turns the texture of the vertices added since `firstVertex` by a quarter: what ran along u runs along v,
/// as the grain of an upright plank.
void turnTextureFrom(Mesh& mesh, std::size_t firstVertex);

/// Points on the ellipse centre + cos(a) axisU + sin(a) axisV, for a from `start` to `end` radians, both
/// included.
std::vector<glm::vec3> arcPath(glm::vec3 centre, glm::vec3 axisU, glm::vec3 axisV, float start, float end,
                               int segments);

/// Counter-clockwise outlines about the origin, for sweeps and extrusions.
std::vector<glm::vec2> circleOutline(float radius, int segments);
std::vector<glm::vec2> rectangleOutline(float width, float height);

/// `texture` with one repeat every `metres`.
TextureUse tiled(int texture, float metres);

/// Collects a scene.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);
  int addMaterial(Material material);  ///< returns its index
  int addImage(Image image);           ///< returns the index of a repeating texture of it
  int addMesh(Mesh mesh);              ///< returns its index; the mesh names its material
  void place(int mesh, const glm::mat4& transform = glm::mat4(1.0f));
  Scene& scene() { return scene_; }
  Scene take() { return std::move(scene_); }

 private:
  Scene scene_;
};

}  // namespace host::modelling
