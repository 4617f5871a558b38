#include "tests/truth/analytic_scenes.h"

#include <utility>

namespace host::test {

Mesh quad(const std::array<glm::vec3, 4>& corners, int material) {
  constexpr std::array<glm::vec2, 4> kUv{{{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}};
  Mesh mesh;
  const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (std::size_t i = 0; i < corners.size(); ++i)
    mesh.vertices.push_back({.position = corners[i], .normal = normal, .uv = kUv[i]});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = material;
  return mesh;
}

Mesh level(float height, glm::vec2 centre, float half, int material) {
  const auto corner = [&](float x, float z) {
    return glm::vec3(centre.x + x * half, height, centre.y + z * half);
  };
  return quad({corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)}, material);
}

Scene sceneOf(std::vector<Mesh> meshes) {
  Scene scene;
  scene.meshes = std::move(meshes);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) scene.instances.push_back({static_cast<int>(i)});
  return scene;
}

void addTexturedMaterial(Scene& scene, AlphaMode mode, const std::vector<std::uint8_t>& alphas) {
  Image& image = scene.images.emplace_back();
  image.size = {alphas.size(), 1};
  for (const std::uint8_t alpha : alphas) image.pixels.insert(image.pixels.end(), {255, 255, 255, alpha});
  scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1, .nearest = true});
  Material& material = scene.materials.emplace_back();
  material.baseColorTexture.texture = static_cast<int>(scene.textures.size()) - 1;
  material.alphaMode = mode;
}

GridSurfaces pointsOnFloor(const std::vector<glm::vec3>& points) {
  GridSurfaces surfaces{{{static_cast<int>(points.size()), 1}, 1}, {}};
  for (const glm::vec3 point : points) surfaces.points.push_back({point, {0.0f, 1.0f, 0.0f}, false});
  return surfaces;
}

}  // namespace host::test
