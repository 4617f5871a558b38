#include "tests/support/synthetic_gbuffer.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace mres::test {
namespace {

double windowDepthOf(const glm::dmat4& projection, ClipDepth clipDepth, glm::dvec3 position) {
  const glm::dvec4 clip = projection * glm::dvec4(position, 1.0);
  return clipDepth == ClipDepth::minusOneToOne ? 0.5 * clip.z / clip.w + 0.5 : clip.z / clip.w;
}

/// The depth that a fixed-point texture of `bits` holds.
double quantised(double windowDepth, int bits) {
  const double steps = std::exp2(bits) - 1.0;
  return std::round(windowDepth * steps) / steps;
}

gl::Texture2D depthTexture(GLenum format, glm::ivec2 size, std::vector<float>& depths) {
  if (format == GL_DEPTH_COMPONENT32F) return {format, size, "test.depth", 1, depths.data()};
  const int bits = format == GL_DEPTH_COMPONENT16 ? 16 : 24;
  std::vector<std::uint16_t> narrow;
  std::vector<std::uint32_t> wide;
  for (float& depth : depths) {
    const double exact = quantised(static_cast<double>(depth), bits);
    narrow.push_back(static_cast<std::uint16_t>(std::lround(exact * 65535.0)));
    wide.push_back(static_cast<std::uint32_t>(std::lround(exact * 4294967295.0)));
    depth = static_cast<float>(exact);
  }
  return {format, size, "test.depth", 1,
          bits == 16 ? static_cast<const void*>(narrow.data()) : static_cast<const void*>(wide.data())};
}

/// The texels of RGBA8 or RGB10_A2 that are nearest to values of 0..1.
std::vector<std::uint32_t> packed(const std::vector<glm::vec4>& values, int bits) {
  const float steps = std::exp2(static_cast<float>(bits)) - 1.0f;
  std::vector<std::uint32_t> texels;
  for (const glm::vec4& value : values) {
    const glm::uvec3 steppedXyz(glm::round(glm::clamp(glm::vec3(value), 0.0f, 1.0f) * steps));
    texels.push_back(steppedXyz.x | steppedXyz.y << bits | steppedXyz.z << (2 * bits));
  }
  return texels;
}

gl::Texture2D normalTexture(glm::ivec2 size, std::vector<glm::vec4> normals, const NormalStorage& storage) {
  const glm::mat3 fromView =
      storage.space == NormalSpace::world ? glm::transpose(glm::mat3(storage.view)) : glm::mat3(1.0f);
  for (glm::vec4& normal : normals) {
    const glm::vec3 turned = fromView * glm::vec3(normal);
    const bool isSigned = storage.encoding == NormalEncoding::signedXyz;
    normal = glm::vec4(isSigned ? turned : turned * 0.5f + 0.5f, 0.0f);
  }
  if (storage.format == GL_RGBA32F) return {GL_RGBA32F, size, "test.normals", 1, normals.data()};
  return {storage.format, size, "test.normals", 1,
          packed(normals, storage.format == GL_RGBA8 ? 8 : 10).data()};
}

/// The ray of a pixel: through the eye for perspective, parallel for orthographic projections.
std::pair<glm::dvec3, glm::dvec3> rayOf(const glm::dmat4& p, glm::dvec2 ndc) {
  if (p[2][3] != 0.0) {
    return {glm::dvec3(0.0), glm::dvec3((ndc.x + p[2][0]) / p[0][0], (ndc.y + p[2][1]) / p[1][1], -1.0)};
  }
  return {glm::dvec3((ndc.x - p[3][0]) / p[0][0], (ndc.y - p[3][1]) / p[1][1], 0.0),
          glm::dvec3(0.0, 0.0, -1.0)};
}

}  // namespace

SyntheticGBuffer::SyntheticGBuffer(glm::ivec2 size, const glm::mat4& projection, const RayCaster& scene,
                                   const DepthStorage& storage, const NormalStorage& normals)
    : frame_{.size = size,
             .view = normals.view,
             .projection = projection,
             .clipDepth = storage.clipDepth,
             .normalSpace = normals.space,
             .normalEncoding = normals.encoding} {
  cast(scene, storage);
  depth_ = depthTexture(storage.format, size, depths_);
  normals_ = normalTexture(size, normalValues_, normals);
  frame_.depth = depth_.id();
  frame_.normals = normals_.id();
}

void SyntheticGBuffer::cast(const RayCaster& scene, const DepthStorage& storage) {
  const glm::dmat4 p(frame_.projection);
  for (int y = 0; y < frame_.size.y; ++y) {
    for (int x = 0; x < frame_.size.x; ++x) {
      const glm::dvec2 ndc = (glm::dvec2(x, y) + 0.5) / glm::dvec2(frame_.size) * 2.0 - 1.0;
      const auto [origin, direction] = rayOf(p, ndc);
      const std::optional<Hit> hit = scene(origin, direction);
      const double depth =
          hit ? windowDepthOf(p, storage.clipDepth, origin + direction * hit->viewDepth) : -1.0;
      const bool visible = depth > 0.0 && depth < 1.0;
      depths_.push_back(visible ? static_cast<float>(depth) : storage.reversed ? 0.0f : 1.0f);
      normalValues_.push_back(visible ? glm::vec4(hit->normal, 0.0) : glm::vec4(0.0f));
    }
  }
}

RayCaster plane(glm::dvec3 normal, double offset) {
  normal = glm::normalize(normal);
  return [=](glm::dvec3 origin, glm::dvec3 direction) -> std::optional<Hit> {
    const double along = glm::dot(normal, direction);
    const double distance = (offset - glm::dot(normal, origin)) / along;
    if (along == 0.0 || distance <= 0.0) return std::nullopt;
    return Hit{distance, along < 0.0 ? normal : -normal};
  };
}

RayCaster nearest(std::vector<RayCaster> scenes) {
  return [scenes = std::move(scenes)](glm::dvec3 origin, glm::dvec3 direction) {
    std::optional<Hit> best;
    for (const RayCaster& scene : scenes) {
      const std::optional<Hit> hit = scene(origin, direction);
      if (hit && (!best || hit->viewDepth < best->viewDepth)) best = hit;
    }
    return best;
  };
}

RayCaster sphere(glm::dvec3 centre, double radius) {
  return [=](glm::dvec3 origin, glm::dvec3 direction) -> std::optional<Hit> {
    const glm::dvec3 offset = origin - centre;
    const double a = glm::dot(direction, direction);
    const double b = glm::dot(offset, direction);
    const double discriminant = b * b - a * (glm::dot(offset, offset) - radius * radius);
    if (discriminant < 0.0) return std::nullopt;
    const double distance = (-b - std::sqrt(discriminant)) / a;
    if (distance <= 0.0) return std::nullopt;
    return Hit{distance, (offset + direction * distance) / radius};
  };
}

RayCaster box(glm::dvec3 min, glm::dvec3 max) {
  return [=](glm::dvec3 origin, glm::dvec3 direction) -> std::optional<Hit> {
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    glm::dvec3 enterNormal(0.0);
    glm::dvec3 leaveNormal(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      const double toMin = (min[axis] - origin[axis]) / direction[axis];
      const double toMax = (max[axis] - origin[axis]) / direction[axis];
      glm::dvec3 facing(0.0);
      facing[axis] = direction[axis] > 0.0 ? -1.0 : 1.0;
      if (std::min(toMin, toMax) > enter) {
        enter = std::min(toMin, toMax);
        enterNormal = facing;
      }
      if (std::max(toMin, toMax) < leave) {
        leave = std::max(toMin, toMax);
        leaveNormal = facing;
      }
    }
    if (enter > leave) return std::nullopt;
    const bool inside = enter <= 0.0;
    return Hit{inside ? leave : enter, inside ? leaveNormal : enterNormal};
  };
}

RayCaster room() {
  std::vector<RayCaster> scenes{box({-4.0, -1.5, -9.0}, {4.0, 2.5, 1.0})};
  for (int i = 0; i < 20; ++i) {
    const double x = -3.6 + 7.2 * std::fmod(i * 0.618034, 1.0);
    const double z = -2.5 - 6.0 * std::fmod(i * 0.754878, 1.0);
    const double side = 0.1 + 0.4 * std::fmod(i * 0.569840, 1.0);
    if (i % 3 == 0) {
      scenes.push_back(sphere({x, -1.5 + side, z}, side));
    } else {
      scenes.push_back(box({x - side, -1.5, z - side}, {x + side, -1.5 + 2.0 * side, z + side}));
    }
  }
  return nearest(std::move(scenes));
}

RayCaster curtain(double depth, double period, double degrees) {
  return [=, wall = plane({0.0, 0.0, 1.0}, -depth)](glm::dvec3 origin, glm::dvec3 direction) {
    std::optional<Hit> hit = wall(origin, direction);
    const double x = origin.x + direction.x * depth;
    const double angle = glm::radians(degrees) * std::sin(glm::radians(360.0) * x / period);
    if (hit) hit->normal = {std::sin(angle), 0.0, std::cos(angle)};
    return hit;
  };
}

RayCaster withRandomNormals(RayCaster scene) {
  auto generator = std::make_shared<std::mt19937>(1);
  return [scene = std::move(scene), generator](glm::dvec3 origin, glm::dvec3 direction) {
    std::normal_distribution<double> random;
    std::optional<Hit> hit = scene(origin, direction);
    if (hit)
      hit->normal = glm::normalize(glm::dvec3(random(*generator), random(*generator), random(*generator)));
    return hit;
  };
}

}  // namespace mres::test
