// One primitive of a glTF mesh, to indexed triangles.
#pragma once

#include <optional>
#include <string>

#include "host/scene/gltf/accessor.h"
#include "host/scene/gltf/document.h"
#include "host/scene/scene.h"

namespace host::gltf {

/// Has positions, and a mode that makes triangles.
bool hasTriangles(const tinygltf::Primitive& primitive);

class PrimitiveReader {
 public:
  /// Opens positions and indices of a primitive that hasTriangles(). `name` names it in messages. Throws
  /// std::runtime_error.
  PrimitiveReader(Document& document, const tinygltf::Primitive& primitive, std::string name);

  [[nodiscard]] std::size_t triangleCount() const;

  /// Only vertices that triangles use, with texture coordinates of TEXCOORD_`uvSet`. Normals and, for a
  /// material with a normal map, tangents are made where they are missing. Triangles with coordinates that
  /// are not finite are dropped, with a warning.
  Mesh read(const Material& material, int uvSet);

 private:
  struct Attributes;

  std::vector<std::uint32_t> validCorners();
  [[nodiscard]] Mesh readVertices(const std::vector<std::uint32_t>& corners,
                                  const Attributes& attributes) const;
  std::optional<Accessor> attribute(const std::string& semantic, int components);

  Document& document_;
  const tinygltf::Primitive& primitive_;
  std::string name_;
  Accessor positions_;
  std::optional<Accessor> indices_;
};

}  // namespace host::gltf
