#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "host/scene/builtin/modelling.h"
#include "host/scene/builtin/surface_grid.h"

namespace host::modelling {
namespace {

/// Swaps the winding of the triangles of the vertices added since `firstVertex`.
void flipFacesFrom(Mesh& mesh, std::size_t firstVertex) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    if (mesh.indices[i] >= firstVertex) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
}

}  // namespace

void transformFrom(Mesh& mesh, std::size_t firstVertex, const glm::mat4& transform) {
  const glm::mat3 linear(transform);
  const glm::mat3 forNormals = glm::transpose(glm::inverse(linear));
  const bool mirrored = glm::determinant(linear) < 0.0f;
  for (std::size_t i = firstVertex; i < mesh.vertices.size(); ++i) {
    Vertex& vertex = mesh.vertices[i];
    vertex.position = glm::vec3(transform * glm::vec4(vertex.position, 1.0f));
    vertex.normal = glm::normalize(forNormals * vertex.normal);
    const glm::vec3 tangent = tangentAlong(linear * glm::vec3(vertex.tangent), vertex.normal);
    vertex.tangent = glm::vec4(tangent, mirrored ? -vertex.tangent.w : vertex.tangent.w);
  }
  if (mirrored) flipFacesFrom(mesh, firstVertex);
}

void turnTextureFrom(Mesh& mesh, std::size_t firstVertex) {
  for (std::size_t i = firstVertex; i < mesh.vertices.size(); ++i) {
    Vertex& vertex = mesh.vertices[i];
    const glm::vec3 up = glm::cross(vertex.normal, glm::vec3(vertex.tangent)) * vertex.tangent.w;
    vertex.uv = {-vertex.uv.y, vertex.uv.x};
    vertex.tangent = glm::vec4(up, vertex.tangent.w);
  }
}

void addMesh(Mesh& mesh, const Mesh& part, const glm::mat4& transform) {
  const std::size_t firstVertex = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const std::uint32_t index : part.indices) {
    mesh.indices.push_back(index + static_cast<std::uint32_t>(firstVertex));
  }
  transformFrom(mesh, firstVertex, transform);
}

std::vector<glm::vec3> arcPath(glm::vec3 centre, glm::vec3 axisU, glm::vec3 axisV, float start, float end,
                               int segments) {
  std::vector<glm::vec3> path;
  for (int i = 0; i <= segments; ++i) {
    const float angle = glm::mix(start, end, static_cast<float>(i) / static_cast<float>(segments));
    path.push_back(centre + std::cos(angle) * axisU + std::sin(angle) * axisV);
  }
  return path;
}

std::vector<glm::vec2> circleOutline(float radius, int segments) {
  std::vector<glm::vec2> outline;
  for (int i = 0; i < segments; ++i) {
    const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

std::vector<glm::vec2> rectangleOutline(float width, float height) {
  const glm::vec2 half(0.5f * width, 0.5f * height);
  return {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
}

TextureUse tiled(int texture, float metres) {
  TextureUse use;
  use.texture = texture;
  use.uvTransform[0][0] = 1.0f / metres;
  use.uvTransform[1][1] = 1.0f / metres;
  return use;
}

}  // namespace host::modelling
