#pragma once

#include "effects/common/sample_points.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {

/// How the points lie.
struct HemisphereSettings {
  double radius;
  double bias;
  int samples;
  int seed;
};

/// What the depth buffer shows where a point of the hemisphere over a pixel is.
struct Sight {
  glm::dvec3 direction;  ///< of the point, view space, unit length
  glm::dvec3 toSurface;  ///< from the pixel's surface to the one that is seen
  glm::ivec2 pixel;      ///< that shows it
  int mip;               ///< of depth: the pixel stands for a block of 2^mip pixels a side
  double blocked;        ///< 0..1: whether it hides the point
};

/// In double precision, at full resolution: what shaders/effects/common/hemisphere.glsl says, written anew.
class HemisphereReference {
 public:
  HemisphereReference(const SyntheticGBuffer& gbuffer, const HemisphereSettings& settings);

  [[nodiscard]] bool isBackground(glm::ivec2 pixel) const;
  [[nodiscard]] glm::dvec3 normalOf(glm::ivec2 pixel) const;

  /// Of all points over a pixel that is no background.
  [[nodiscard]] std::vector<Sight> sightsFrom(glm::ivec2 pixel) const;

 private:
  struct Receiver {
    glm::dvec3 position;
    glm::dmat3 frame;  ///< columns: axes of the points, the third is the normal
    double clipW;
  };
  [[nodiscard]] std::size_t indexOf(glm::ivec2 pixel) const;
  [[nodiscard]] glm::dvec3 positionOf(glm::ivec2 pixel) const;
  [[nodiscard]] int mipAt(double distance, double originW) const;
  [[nodiscard]] glm::ivec2 pixelSeenAt(glm::dvec3 point, int mip) const;
  [[nodiscard]] Sight sightOf(glm::dvec3 sample, const Receiver& from) const;

  const SyntheticGBuffer& gbuffer_;
  HemisphereSettings settings_;
  std::vector<glm::vec3> points_;
  glm::dmat4 projection_;
  glm::dmat4 inverseProjection_;
};

}  // namespace mres::test
