#include "host/scene/builtin/modelling.h"

namespace host::modelling {
namespace {

template <typename T>
int append(std::vector<T>& list, T item) {
  list.push_back(std::move(item));
  return static_cast<int>(list.size()) - 1;
}

}  // namespace

SceneBuilder::SceneBuilder(std::string name) {
  scene_.name = std::move(name);
}

int SceneBuilder::addMaterial(Material material) {
  return append(scene_.materials, std::move(material));
}

int SceneBuilder::addImage(Image image) {
  Texture texture;
  texture.image = append(scene_.images, std::move(image));
  return append(scene_.textures, texture);
}

int SceneBuilder::addMesh(Mesh mesh) {
  return append(scene_.meshes, std::move(mesh));
}

void SceneBuilder::place(int mesh, const glm::mat4& transform) {
  scene_.instances.push_back({mesh, transform});
}

}  // namespace host::modelling
