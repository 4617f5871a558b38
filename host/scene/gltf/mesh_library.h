// Meshes, converted when a node first uses them.
#pragma once

#include <map>
#include <span>

#include "host/scene/gltf/document.h"
#include "host/scene/scene.h"

namespace host::gltf {

class MeshLibrary {
 public:
  /// Adds to `scene`, whose materials are there already; `uvSets` is what convertMaterials() returned. The
  /// document and the scene must outlive this.
  MeshLibrary(Document& document, Scene& scene, std::vector<int> uvSets);

  /// The scene's meshes for a glTF mesh, one for each primitive that has triangles. Throws
  /// std::runtime_error.
  std::span<const int> use(int gltfMesh);

 private:
  std::vector<int> convert(int gltfMesh);
  Mesh convertPrimitive(const tinygltf::Primitive& primitive, const std::string& name);
  int materialOf(const tinygltf::Primitive& primitive, const std::string& name);
  void charge(std::size_t triangles);

  Document& document_;
  Scene& scene_;
  std::vector<int> uvSets_;
  std::map<int, std::vector<int>> meshes_;  ///< glTF index to scene indices
  std::size_t triangleBudget_ = 0;
};

}  // namespace host::gltf
