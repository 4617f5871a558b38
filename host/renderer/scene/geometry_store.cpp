#include "host/renderer/scene/geometry_store.h"

#include <cstddef>
#include <limits>

namespace host {
namespace {

constexpr GLuint kFirstInstanceAttribute = 4;
constexpr GLuint kInstanceRows = 3;

const void* bufferOffset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): OpenGL wants it so
}

Bounds boundsOfMesh(const Mesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Bounds bounds{glm::vec3(std::numeric_limits<float>::max()),
                glm::vec3(std::numeric_limits<float>::lowest())};
  for (const Vertex& vertex : mesh.vertices) {
    bounds.min = glm::min(bounds.min, vertex.position);
    bounds.max = glm::max(bounds.max, vertex.position);
  }
  return bounds;
}

template <class T>
void uploadPart(GLenum target, std::size_t firstByte, const std::vector<T>& data) {
  glBufferSubData(target, static_cast<GLintptr>(firstByte), static_cast<GLsizeiptr>(data.size() * sizeof(T)),
                  data.data());
}

}  // namespace

GeometryStore::GeometryStore(std::span<const Mesh> meshes)
    : vertexArray_(mres::gl::VertexArrayName::create()),
      vertices_(mres::gl::BufferName::create()),
      indices_(mres::gl::BufferName::create()),
      instances_(mres::gl::BufferName::create()) {
  std::size_t vertexCount = 0;
  std::size_t indexBytes = 0;
  for (const Mesh& mesh : meshes) {
    ranges_.push_back({static_cast<GLsizei>(mesh.indices.size()), indexBytes, static_cast<GLint>(vertexCount),
                       boundsOfMesh(mesh)});
    vertexCount += mesh.vertices.size();
    indexBytes += mesh.indices.size() * sizeof(std::uint32_t);
  }
  bytes_ = vertexCount * sizeof(Vertex) + indexBytes;

  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertexCount * sizeof(Vertex)), nullptr,
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indexBytes), nullptr, GL_STATIC_DRAW);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    uploadPart(GL_ARRAY_BUFFER, static_cast<std::size_t>(ranges_[i].baseVertex) * sizeof(Vertex),
               meshes[i].vertices);
    uploadPart(GL_ELEMENT_ARRAY_BUFFER, ranges_[i].firstIndexByte, meshes[i].indices);
  }
  describeVertices();
}

void GeometryStore::describeVertices() const {
  const auto attribute = [](GLuint index, GLint components, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(Vertex), bufferOffset(offset));
  };
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 4, offsetof(Vertex, tangent));
  attribute(3, 2, offsetof(Vertex, uv));
  for (GLuint row = 0; row < kInstanceRows; ++row) {
    glEnableVertexAttribArray(kFirstInstanceAttribute + row);
    glVertexAttribDivisor(kFirstInstanceAttribute + row, 1);
  }
}

void GeometryStore::begin(std::span<const InstanceData> instances) const {
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
               GL_STREAM_DRAW);
}

void GeometryStore::draw(int mesh, std::size_t first, std::size_t count) const {
  // OpenGL 3.3 has no base instance: the attributes are pointed at the first one instead.
  for (GLuint row = 0; row < kInstanceRows; ++row) {
    glVertexAttribPointer(kFirstInstanceAttribute + row, 4, GL_FLOAT, GL_FALSE, sizeof(InstanceData),
                          bufferOffset(first * sizeof(InstanceData) + row * sizeof(glm::vec4)));
  }
  const MeshRange& drawn = range(mesh);
  glDrawElementsInstancedBaseVertex(GL_TRIANGLES, drawn.indexCount, GL_UNSIGNED_INT,
                                    bufferOffset(drawn.firstIndexByte), static_cast<GLsizei>(count),
                                    drawn.baseVertex);
}

}  // namespace host
