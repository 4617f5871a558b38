#include "tests/unit/mesh_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <functional>
#include <map>
#include <tuple>

namespace host::test {
namespace {

using Triangle = std::array<Vertex, 3>;

void forEachTriangle(const Mesh& mesh, const std::function<void(const Triangle&)>& visit) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    visit({mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
           mesh.vertices[mesh.indices[i + 2]]});
  }
}

glm::dvec3 areaVector(const Triangle& t) {
  const glm::dvec3 origin(t[0].position);
  return 0.5 * glm::cross(glm::dvec3(t[1].position) - origin, glm::dvec3(t[2].position) - origin);
}

double uvArea(const Triangle& t) {
  const glm::dvec2 a(t[1].uv - t[0].uv);
  const glm::dvec2 b(t[2].uv - t[0].uv);
  return 0.5 * std::abs(a.x * b.y - a.y * b.x);
}

std::string faultOf(const Vertex& vertex) {
  const glm::vec3 tangent(vertex.tangent);
  if (std::abs(glm::length(vertex.normal) - 1.0f) > 1e-3f) return "a normal is not unit length";
  if (std::abs(glm::length(tangent) - 1.0f) > 1e-3f) return "a tangent is not unit length";
  if (std::abs(glm::dot(vertex.normal, tangent)) > 1e-3f) return "a tangent is not orthogonal to its normal";
  if (std::abs(vertex.tangent.w) != 1.0f) return "a tangent's handedness is neither +1 nor -1";
  return std::isfinite(vertex.uv.x + vertex.uv.y) ? "" : "a texture coordinate is not finite";
}

std::string faultOf(const Triangle& t) {
  const glm::dvec3 area = areaVector(t);
  if (glm::length(area) < 1e-11) {
    return fmt::format("a triangle at {} {} {} has no area", t[0].position.x, t[0].position.y,
                       t[0].position.z);
  }
  for (const Vertex& vertex : t) {
    if (glm::dot(area, glm::dvec3(vertex.normal)) <= 0.0) {
      return fmt::format("a normal at {} {} {} lies behind its triangle", vertex.position.x,
                         vertex.position.y, vertex.position.z);
    }
  }
  return "";
}

using Point = std::tuple<long, long, long>;

Point quantised(glm::vec3 p) {
  constexpr float kPerMetre = 1e4f;
  return {std::lround(p.x * kPerMetre), std::lround(p.y * kPerMetre), std::lround(p.z * kPerMetre)};
}

}  // namespace

std::string faultOf(const Mesh& mesh) {
  if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) return mesh.name + ": no or incomplete triangles";
  for (const std::uint32_t index : mesh.indices) {
    if (index >= mesh.vertices.size()) return mesh.name + ": an index is out of range";
  }
  for (const Vertex& vertex : mesh.vertices) {
    if (const std::string fault = faultOf(vertex); !fault.empty()) return mesh.name + ": " + fault;
  }
  std::string found;
  forEachTriangle(mesh, [&](const Triangle& t) {
    if (found.empty()) found = faultOf(t);
  });
  return found.empty() ? "" : mesh.name + ": " + found;
}

std::string leakOf(const Mesh& mesh) {
  std::map<std::pair<Point, Point>, int> balance;
  forEachTriangle(mesh, [&](const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = quantised(t[i].position);
      const Point b = quantised(t[(i + 1) % 3].position);
      if (a < b) ++balance[{a, b}];
      if (b < a) --balance[{b, a}];
    }
  });
  for (const auto& [edge, count] : balance) {
    if (count == 0) continue;
    const auto [x, y, z] = edge.first;
    return fmt::format("an edge at {} {} {} (tenths of a millimetre) is open", x, y, z);
  }
  return "";
}

double volumeOf(const Mesh& mesh) {
  double volume = 0.0;
  forEachTriangle(
      mesh, [&](const Triangle& t) { volume += glm::dot(areaVector(t), glm::dvec3(t[0].position)) / 3.0; });
  return volume;
}

double areaOf(const Mesh& mesh) {
  double area = 0.0;
  forEachTriangle(mesh, [&](const Triangle& t) { area += glm::length(areaVector(t)); });
  return area;
}

double worstTangentError(const Mesh& mesh) {
  double worst = 0.0;
  forEachTriangle(mesh, [&](const Triangle& t) {
    const glm::dvec3 e1(t[1].position - t[0].position);
    const glm::dvec3 e2(t[2].position - t[0].position);
    const glm::dvec2 d1(t[1].uv - t[0].uv);
    const glm::dvec2 d2(t[2].uv - t[0].uv);
    const double determinant = d1.x * d2.y - d1.y * d2.x;
    if (std::abs(determinant) < 1e-12) return;
    const glm::dvec3 alongU = (e1 * d2.y - e2 * d1.y) / determinant;
    const glm::dvec3 alongV = (e2 * d1.x - e1 * d2.x) / determinant;
    for (const Vertex& vertex : t) {
      const glm::vec3 tangent(vertex.tangent);
      const glm::vec3 bitangent = glm::cross(vertex.normal, tangent) * vertex.tangent.w;
      worst = std::max({worst, 1.0 - glm::dot(glm::normalize(alongU), glm::dvec3(tangent)),
                        1.0 + glm::dot(glm::normalize(alongV), glm::dvec3(bitangent))});
    }
  });
  return worst;
}

double uvAreaRatio(const Mesh& mesh) {
  double area = 0.0;
  forEachTriangle(mesh, [&](const Triangle& t) { area += uvArea(t); });
  return area / areaOf(mesh);
}

}  // namespace host::test
