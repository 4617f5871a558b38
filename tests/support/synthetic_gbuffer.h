#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "mres/frame.h"
#include "mres/gl/texture.h"

namespace mres::test {

/// What a camera ray meets: distance along -Z in view space and the view-space normal.
struct Hit {
  double viewDepth = 0.0;
  glm::dvec3 normal{0.0};
};

/// The scene of a synthetic G-buffer: a view-space ray (origin, direction with z = -1) to what it meets;
/// nothing is background.
using RayCaster = std::function<std::optional<Hit>(glm::dvec3 origin, glm::dvec3 direction)>;

/// How a G-buffer stores depth.
struct DepthStorage {
  GLenum format = GL_DEPTH_COMPONENT32F;  ///< or GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24
  ClipDepth clipDepth = ClipDepth::minusOneToOne;
  bool reversed = false;  ///< the far plane is at window depth 0
};

/// How a G-buffer stores normals.
struct NormalStorage {
  GLenum format = GL_RGBA32F;  ///< or GL_RGB10_A2, GL_RGBA8, which need NormalEncoding::unsignedXyz
  NormalEncoding encoding = NormalEncoding::signedXyz;
  NormalSpace space = NormalSpace::view;
  glm::mat4 view{1.0f};  ///< Frame::view
};

/// Depth and normals of a scene that is cast in double precision, and the frame that hands them to mres. What
/// lies beyond the far plane is background.
class SyntheticGBuffer {
 public:
  SyntheticGBuffer(glm::ivec2 size, const glm::mat4& projection, const RayCaster& scene,
                   const DepthStorage& storage = {}, const NormalStorage& normals = {});
  [[nodiscard]] const Frame& frame() const { return frame_; }
  /// Window depths as the texture stores them, rows bottom to top.
  [[nodiscard]] const std::vector<float>& depths() const { return depths_; }
  /// In view space, exact.
  [[nodiscard]] const std::vector<glm::vec4>& normals() const { return normalValues_; }

 private:
  void cast(const RayCaster& scene, const DepthStorage& storage);

  std::vector<float> depths_;
  std::vector<glm::vec4> normalValues_;
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

/// A wall across the view at a depth, whose normals swing along x as those of a curtain do: with a period of
/// metres, up to `degrees`.
RayCaster curtain(double depth, double period, double degrees);

/// Every normal points elsewhere, so that everything is an edge.
RayCaster withRandomNormals(RayCaster scene);

}  // namespace mres::test
