#include "host/scene/builtin/furniture_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/quaternion.hpp>
#include <ranges>

namespace host::furniture {

namespace {

constexpr float kSunk = 0.01f;  // metres a moulding reaches into its wall, so that no faces coincide

struct Frame {
  TubePoint at;
  glm::vec3 side;
  glm::vec3 up;
};

// Rotation-minimising frames: each is the last one turned by the smallest rotation between the two tangents,
// so that the tube doesn't twist.
std::vector<Frame> framesAlong(std::span<const TubePoint> points, int count) {
  std::vector<TubePoint> at;
  for (int i = 0; i <= count; ++i)
    at.push_back(alongCurve(points, static_cast<float>(i) / static_cast<float>(count)));

  std::vector<Frame> frames;
  glm::vec3 lastTangent(0.0f);
  for (int i = 0; i <= count; ++i) {
    const glm::vec3 tangent =
        glm::normalize(at[std::min(i + 1, count)].position - at[std::max(i - 1, 0)].position);
    if (i == 0) {
      const glm::vec3 away = std::abs(tangent.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
      const glm::vec3 side = glm::normalize(glm::cross(away, tangent));
      frames.push_back({at[0], side, glm::cross(tangent, side)});
    } else {
      const glm::quat turn = glm::rotation(lastTangent, tangent);
      const glm::vec3 side = glm::normalize(turn * frames.back().side);
      frames.push_back({at[i], side, glm::cross(tangent, side)});
    }
    lastTangent = tangent;
  }
  return frames;
}

std::vector<glm::vec2> roundedRectangle(glm::vec2 size, float radius, int cornerSegments) {
  std::vector<glm::vec2> outline;
  for (int corner = 0; corner < 4; ++corner) {
    const glm::vec2 sign(corner == 0 || corner == 3 ? 1.0f : -1.0f, corner < 2 ? 1.0f : -1.0f);
    const glm::vec2 centre = sign * (size * 0.5f - radius);
    for (int i = 0; i <= cornerSegments; ++i) {
      const float turn =
          static_cast<float>(corner) + static_cast<float>(i) / static_cast<float>(cornerSegments);
      const float angle = turn * glm::half_pi<float>();
      outline.push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return outline;
}

float signedPower(float x, float exponent) {
  return std::copysign(std::pow(std::abs(x), exponent), x);
}

}  // namespace

TubePoint alongCurve(std::span<const TubePoint> points, float t) {
  const int last = static_cast<int>(points.size()) - 1;
  const float scaled = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(last);
  const int i = std::min(static_cast<int>(scaled), last - 1);
  const float f = scaled - static_cast<float>(i);
  const auto knot = [&](int k) {
    const TubePoint& point = points[std::clamp(k, 0, last)];
    return glm::vec4(point.position, point.radius);
  };
  const glm::vec4 a = knot(i - 1);
  const glm::vec4 b = knot(i);
  const glm::vec4 c = knot(i + 1);
  const glm::vec4 d = knot(i + 2);
  const glm::vec4 p = 0.5f * (2.0f * b + (c - a) * f + (2.0f * a - 5.0f * b + 4.0f * c - d) * f * f +
                              (3.0f * b - a - 3.0f * c + d) * f * f * f);
  return {glm::vec3(p), p.w};
}

void addTube(Mesh& mesh, std::span<const TubePoint> points, glm::ivec2 segments) {
  const std::vector<Frame> frames = framesAlong(points, segments.y);
  const auto surface = [&](float u, float v) {
    const float scaled = std::clamp(v, 0.0f, 1.0f) * static_cast<float>(segments.y);
    const int i = std::min(static_cast<int>(scaled), segments.y - 1);
    const float f = scaled - static_cast<float>(i);
    const Frame& a = frames[i];
    const Frame& b = frames[i + 1];
    const float angle = u * glm::two_pi<float>();
    const glm::vec3 out = glm::normalize(glm::mix(a.side, b.side, f) * std::cos(angle) +
                                         glm::mix(a.up, b.up, f) * std::sin(angle));
    return glm::mix(a.at.position, b.at.position, f) + out * glm::mix(a.at.radius, b.at.radius, f);
  };
  modelling::addPatch(mesh, surface, segments);
}

void addMoulding(Mesh& mesh, std::span<const glm::vec2> profile, std::span<const glm::vec3> path, Ends ends) {
  // The wall is to the right of the way, so the section runs up behind the moulding and down its face.
  std::vector<glm::vec2> section{{kSunk, profile.front().y}, {kSunk, profile.back().y}};
  for (const glm::vec2 point : std::views::reverse(profile)) section.emplace_back(-point.x, point.y);
  modelling::addSweep(mesh, section, path, ends == Ends::joined);
}

void addFrame(Mesh& mesh, glm::vec2 size, std::span<const glm::vec2> section) {
  const glm::vec2 h = size * 0.5f;
  const std::array<glm::vec3, 4> path{
      glm::vec3(-h.x, -h.y, 0), {h.x, -h.y, 0}, {h.x, h.y, 0}, {-h.x, h.y, 0}};
  modelling::addSweep(mesh, section, path, true, 40.0f, {0.0f, 0.0f, 1.0f});
}

void addPrism(Mesh& mesh, std::span<const glm::vec2> outline, float bottom, float height) {
  const std::size_t first = mesh.vertices.size();
  modelling::addExtrusion(mesh, outline, height);
  // A quarter turn about x takes the outline's y to +Z and the extrusion down, from its top.
  const glm::mat4 top = glm::translate(glm::mat4(1.0f), {0.0f, bottom + height, 0.0f});
  modelling::transformFrom(mesh, first, glm::rotate(top, glm::half_pi<float>(), {1.0f, 0.0f, 0.0f}));
}

void addRoundedBoard(Mesh& mesh, glm::vec2 size, float cornerRadius, float bottom, float thickness,
                     int cornerSegments) {
  addPrism(mesh, roundedRectangle(size, cornerRadius, cornerSegments), bottom, thickness);
}

void addTableTop(Mesh& mesh, glm::vec2 size, float cornerRadius, float bottom, float top,
                 int cornerSegments) {
  const float edge = 0.5f * (top - bottom);
  const glm::vec2 flat = size - 2.0f * edge;
  addRoundedBoard(mesh, flat, cornerRadius - edge, bottom, top - bottom, cornerSegments);
  std::vector<glm::vec3> path;
  for (const glm::vec2 p : roundedRectangle(flat, cornerRadius - edge, cornerSegments))
    path.emplace_back(p.x, bottom, -p.y);
  std::vector<glm::vec2> nosing{{0.0f, 0.0f}};
  constexpr int kArc = 8;
  for (int i = 0; i <= kArc; ++i) {
    const float angle = glm::pi<float>() * (static_cast<float>(i) / kArc - 0.5f);
    nosing.emplace_back(edge * std::cos(angle), edge + edge * std::sin(angle));
  }
  modelling::addSweep(mesh, nosing, path, true);
}

glm::vec3 superellipsoid(glm::vec3 radii, glm::vec2 exponents, float u, float v) {
  const float around = u * glm::two_pi<float>();
  const float rise = (v - 0.5f) * glm::pi<float>();
  const float ring = std::pow(std::max(std::cos(rise), 0.0f), exponents.y);
  return radii * glm::vec3(ring * signedPower(std::sin(around), exponents.x),
                           signedPower(std::sin(rise), exponents.y),
                           ring * signedPower(std::cos(around), exponents.x));
}

void addCushion(Mesh& mesh, glm::vec3 centre, glm::vec3 radii, glm::vec2 exponents, glm::ivec2 segments) {
  modelling::addPatch(
      mesh, [&](float u, float v) { return centre + superellipsoid(radii, exponents, u, v); }, segments);
}

void addBlock(Mesh& mesh, glm::vec3 base, glm::vec3 size, float bevel) {
  const glm::vec3 half(size.x * 0.5f, 0.0f, size.z * 0.5f);
  modelling::addBox(mesh, base - half, base + half + glm::vec3(0.0f, size.y, 0.0f), bevel);
}

void addRod(Mesh& mesh, glm::vec3 from, glm::vec3 to, float radius, int segments) {
  const std::array<glm::vec3, 2> path{from, to};
  const glm::vec3 along = glm::normalize(to - from);
  const glm::vec3 up = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  modelling::addSweep(mesh, modelling::circleOutline(radius, segments), path, false, 40.0f, up);
}

void aimFrom(Mesh& mesh, std::size_t firstVertex, glm::vec3 axis, glm::vec3 position) {
  const glm::quat turn = glm::rotation(glm::vec3(0.0f, 1.0f, 0.0f), glm::normalize(axis));
  modelling::transformFrom(mesh, firstVertex,
                           glm::translate(glm::mat4(1.0f), position) * glm::mat4_cast(turn));
}

}  // namespace host::furniture
