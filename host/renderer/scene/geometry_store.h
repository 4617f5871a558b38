#pragma once

#include <span>
#include <vector>

#include "host/scene/scene.h"
#include "mres/gl/object.h"

namespace host {

/// What the vertex shader gets for each instance: the rows of its affine map, into the camera-relative world.
struct InstanceData {
  glm::vec4 row0;
  glm::vec4 row1;
  glm::vec4 row2;
};

/// All meshes in one vertex and one index buffer, and the stream of instances that are drawn.
class GeometryStore {
 public:
  explicit GeometryStore(std::span<const Mesh> meshes);

  [[nodiscard]] bool isEmpty(int mesh) const { return range(mesh).indexCount == 0; }
  /// In the mesh's own space.
  [[nodiscard]] const Bounds& bounds(int mesh) const { return range(mesh).bounds; }

  /// Replaces the stream of instances and binds everything for draw().
  void begin(std::span<const InstanceData> instances) const;
  /// Draws `count` instances from number `first` of the stream on.
  void draw(int mesh, std::size_t first, std::size_t count) const;

  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct MeshRange {
    GLsizei indexCount = 0;
    std::size_t firstIndexByte = 0;
    GLint baseVertex = 0;
    Bounds bounds;
  };
  [[nodiscard]] const MeshRange& range(int mesh) const { return ranges_[static_cast<std::size_t>(mesh)]; }
  void describeVertices() const;

  mres::gl::VertexArrayName vertexArray_;
  mres::gl::BufferName vertices_;
  mres::gl::BufferName indices_;
  mres::gl::BufferName instances_;
  std::vector<MeshRange> ranges_;
  std::size_t bytes_ = 0;
};

}  // namespace host
