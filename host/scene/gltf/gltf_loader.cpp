#include "host/scene/gltf/gltf_loader.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "host/scene/gltf/cameras_lights.h"
#include "host/scene/gltf/document.h"
#include "host/scene/gltf/materials.h"
#include "host/scene/gltf/mesh_library.h"
#include "host/scene/gltf/nodes.h"

namespace host {
namespace {

/// Flattened to nothing, an instance has no normals and cannot be seen.
bool hasVolume(const glm::mat4& transform) {
  return glm::determinant(glm::dmat3(transform)) != 0.0;
}

void convertInstances(gltf::Document& document, const std::vector<gltf::PlacedNode>& nodes, Scene& scene) {
  gltf::MeshLibrary meshes(document, scene, gltf::convertMaterials(document, scene));
  for (const gltf::PlacedNode& placed : nodes) {
    if (placed.node->mesh == -1) continue;
    const auto converted = meshes.use(placed.node->mesh);
    if (!hasVolume(placed.transform)) {
      document.warnings.push_back(
          fmt::format("Node '{}' is left out: its scale is zero.", placed.node->name));
      continue;
    }
    for (const int mesh : converted) scene.instances.push_back({mesh, placed.transform});
  }
}

void convertCamerasAndLights(gltf::Document& document, const std::vector<gltf::PlacedNode>& nodes,
                             Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  for (const gltf::PlacedNode& placed : nodes) {
    if (auto camera = gltf::convertCamera(document, placed, bounds))
      scene.cameras.push_back(std::move(*camera));
    if (auto light = gltf::convertLight(document, placed)) scene.lights.push_back(std::move(*light));
  }
}

}  // namespace

Scene loadGltf(const std::filesystem::path& path) {
  try {
    gltf::Document document = gltf::readDocument(path);
    Scene scene;
    scene.name = path.stem().string();
    const std::vector<gltf::PlacedNode> nodes = gltf::placedNodes(document);
    convertInstances(document, nodes, scene);
    convertCamerasAndLights(document, nodes, scene);
    scene.warnings = std::move(document.warnings);
    return scene;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("can't load '{}': {}", path.string(), error.what()));
  }
}

}  // namespace host
