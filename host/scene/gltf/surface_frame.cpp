#include "host/scene/gltf/surface_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace host::gltf {
namespace {

// Cross products of tiny triangles vanish in single precision, hence double.

/// Twice the area times the unit normal.
glm::dvec3 areaNormal(const Mesh& mesh, std::size_t firstCorner) {
  const auto position = [&](std::size_t corner) {
    return glm::dvec3(mesh.vertices[mesh.indices[firstCorner + corner]].position);
  };
  return glm::cross(position(1) - position(0), position(2) - position(0));
}

glm::vec3 normalizedOr(const glm::dvec3& vector, glm::vec3 fallback) {
  const double length = glm::length(vector);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(vector / length) : fallback;
}

/// Any unit vector perpendicular to `normal`: the projection of the axis that is farthest from it.
glm::vec3 anyPerpendicular(glm::vec3 normal) {
  const glm::vec3 axis =
      std::abs(normal.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
  return glm::normalize(axis - normal * glm::dot(normal, axis));
}

glm::vec3 orthonormalized(const glm::dvec3& tangent, glm::vec3 normal) {
  const glm::dvec3 n(normal);
  const glm::dvec3 projected = tangent - n * glm::dot(n, tangent);
  // What is left of a tangent along the normal is rounding noise.
  if (glm::length(projected) <= 1e-6 * glm::length(tangent)) return anyPerpendicular(normal);
  return normalizedOr(projected, anyPerpendicular(normal));
}

/// What one triangle says about the tangent.
struct TriangleTangent {
  glm::dvec3 direction{0.0};  ///< of growing u, unit length
  int side = 0;               ///< +1, -1 for mirrored coordinates, 0 for degenerate ones
};

/// Solves edge = u * tangent + v * bitangent for two edges (Lengyel, Foundations of Game Engine Development
/// 2, section 7.5). glTF's v points down the image while its normal maps' +Y points up, so the unmirrored
/// case has a negative determinant.
TriangleTangent triangleTangent(const std::array<Vertex, 3>& corners, const glm::mat3& uvTransform) {
  const auto uv = [&](int i) { return glm::dvec2(uvTransform * glm::vec3(corners[i].uv, 1.0f)); };
  const glm::dvec2 uv1 = uv(1) - uv(0);
  const glm::dvec2 uv2 = uv(2) - uv(0);
  const glm::dvec3 edge1 = glm::dvec3(corners[1].position) - glm::dvec3(corners[0].position);
  const glm::dvec3 edge2 = glm::dvec3(corners[2].position) - glm::dvec3(corners[0].position);
  const double determinant = uv1.x * uv2.y - uv2.x * uv1.y;
  const glm::dvec3 scaled = (edge1 * uv2.y - edge2 * uv1.y) * (determinant < 0.0 ? -1.0 : 1.0);
  const double length = glm::length(scaled);
  if (determinant == 0.0 || !(length > 0.0) || !std::isfinite(length)) return {};
  return {scaled / length, determinant < 0.0 ? 1 : -1};
}

/// The corner's angle is its weight, as in MikkTSpace, so that the result does not depend on the
/// triangulation.
double cornerAngle(const std::array<Vertex, 3>& corners, int corner) {
  const auto edge = [&](int to) {
    return glm::dvec3(corners[(corner + to) % 3].position) - glm::dvec3(corners[corner].position);
  };
  const double lengths = glm::length(edge(1)) * glm::length(edge(2));
  return lengths > 0.0 ? std::acos(std::clamp(glm::dot(edge(1), edge(2)) / lengths, -1.0, 1.0)) : 0.0;
}

/// The sums of the tangents around each vertex, one for each side.
class TangentSums {
 public:
  explicit TangentSums(std::size_t vertexCount) : sums_(vertexCount) {}

  void add(std::uint32_t vertex, int side, const glm::dvec3& tangent) { of(vertex, side) += tangent; }
  [[nodiscard]] bool has(std::uint32_t vertex, int side) const {
    return sums_[vertex][slot(side)] != glm::dvec3(0.0);
  }
  glm::dvec3& of(std::uint32_t vertex, int side) { return sums_[vertex][slot(side)]; }

 private:
  static std::size_t slot(int side) { return side < 0 ? 1 : 0; }
  std::vector<std::array<glm::dvec3, 2>> sums_;
};

std::array<Vertex, 3> cornersOf(const Mesh& mesh, std::size_t firstCorner) {
  return {mesh.vertices[mesh.indices[firstCorner]], mesh.vertices[mesh.indices[firstCorner + 1]],
          mesh.vertices[mesh.indices[firstCorner + 2]]};
}

}  // namespace

void addFlatNormals(Mesh& mesh) {
  std::vector<Vertex> vertices;
  vertices.reserve(mesh.indices.size());
  for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
    const glm::vec3 normal = normalizedOr(areaNormal(mesh, first), glm::vec3(0.0f, 1.0f, 0.0f));
    for (std::size_t corner = first; corner < first + 3; ++corner) {
      vertices.push_back(mesh.vertices[mesh.indices[corner]]);
      vertices.back().normal = normal;
    }
  }
  mesh.vertices = std::move(vertices);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = std::uint32_t(i);
}

void repairNormals(Mesh& mesh) {
  std::vector<glm::dvec3> sums;
  const bool anyMissing = std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vertex& vertex) {
    return normalizedOr(vertex.normal, glm::vec3(0.0f)) == glm::vec3(0.0f);
  });
  if (anyMissing) {
    sums.resize(mesh.vertices.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
      sums[mesh.indices[i]] += areaNormal(mesh, i - i % 3);
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::vec3 fallback =
        anyMissing ? normalizedOr(sums[i], glm::vec3(0.0f, 1.0f, 0.0f)) : glm::vec3(0.0f, 1.0f, 0.0f);
    mesh.vertices[i].normal = normalizedOr(mesh.vertices[i].normal, fallback);
  }
}

void addTangents(Mesh& mesh, const glm::mat3& uvTransform) {
  TangentSums sums(mesh.vertices.size());
  std::vector<int> sides(mesh.indices.size() / 3);
  for (std::size_t triangle = 0; triangle < sides.size(); ++triangle) {
    const auto corners = cornersOf(mesh, triangle * 3);
    const TriangleTangent tangent = triangleTangent(corners, uvTransform);
    sides[triangle] = tangent.side;
    if (tangent.side == 0) continue;
    for (int corner = 0; corner < 3; ++corner) {
      sums.add(mesh.indices[triangle * 3 + std::size_t(corner)], tangent.side,
               tangent.direction * cornerAngle(corners, corner));
    }
  }

  const auto vertexCount = std::uint32_t(mesh.vertices.size());
  std::vector<std::uint32_t> mirrored(vertexCount);  // where the mirrored triangles find their vertex
  for (std::uint32_t i = 0; i < vertexCount; ++i) {
    const bool isMirrored = sums.has(i, -1);
    const bool isSplit = isMirrored && sums.has(i, +1);
    mirrored[i] = isSplit ? std::uint32_t(mesh.vertices.size()) : i;
    if (isSplit) mesh.vertices.push_back(mesh.vertices[i]);
    const auto assign = [&](Vertex& vertex, int side) {
      vertex.tangent = glm::vec4(orthonormalized(sums.of(i, side), vertex.normal), float(side));
    };
    if (isMirrored) assign(mesh.vertices[mirrored[i]], -1);
    if (isSplit || !isMirrored) assign(mesh.vertices[i], +1);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (sides[i / 3] < 0) mesh.indices[i] = mirrored[mesh.indices[i]];
  }
}

void repairTangents(Mesh& mesh) {
  for (Vertex& vertex : mesh.vertices) {
    const float handedness = vertex.tangent.w < 0.0f ? -1.0f : 1.0f;
    vertex.tangent = glm::vec4(orthonormalized(glm::dvec3(vertex.tangent), vertex.normal), handedness);
  }
}

}  // namespace host::gltf
