#include "tests/gpu/renderer_support.h"

#include "host/scene/builtin/modelling.h"

namespace host::test {

Mesh square(int material) {
  Mesh mesh;
  mesh.material = material;
  modelling::addQuad(mesh, {-1.0f, -1.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f});
  for (Vertex& vertex : mesh.vertices) {
    vertex.uv = {vertex.position.x * 0.5f + 0.5f, 0.5f - vertex.position.y * 0.5f};
  }
  return mesh;
}

Mesh cube(int material) {
  Mesh mesh;
  mesh.material = material;
  modelling::addBox(mesh, glm::vec3(-1.0f), glm::vec3(1.0f));
  return mesh;
}

Material chalk() {
  Material material;
  material.metallic = 0.0f;
  return material;
}

Light sunAlong(glm::vec3 direction, float lux) {
  Light sun;
  sun.direction = direction;
  sun.intensity = lux;
  return sun;
}

Scene darkScene() {
  Scene scene;
  scene.ambient = glm::vec3(0.0f);
  scene.sky.intensity = 0.0f;
  return scene;
}

void place(Scene& scene, const Mesh& mesh, const Material& material, const glm::mat4& transform) {
  scene.meshes.push_back(mesh);
  scene.meshes.back().material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, transform});
}

int addTexture(Scene& scene, glm::ivec2 size, std::vector<std::uint8_t> pixels) {
  scene.images.push_back({"test", size, std::move(pixels)});
  Texture texture;
  texture.image = static_cast<int>(scene.images.size()) - 1;
  texture.nearest = true;
  scene.textures.push_back(texture);
  return static_cast<int>(scene.textures.size()) - 1;
}

Camera frontCamera(float distance) {
  Camera camera = lookAt("front", {0.0f, 0.0f, distance}, glm::vec3(0.0f), 40.0f);
  camera.nearPlane = 0.1f;
  camera.farPlane = 50.0f;
  return camera;
}

glm::vec4 pixel(const FloatImage& image, glm::ivec2 at) {
  glm::vec4 value(0.0f, 0.0f, 0.0f, 1.0f);
  const auto first =
      static_cast<std::size_t>(at.y * image.size.x + at.x) * static_cast<std::size_t>(image.channels);
  for (int channel = 0; channel < image.channels; ++channel) {
    value[channel] = image.pixels.at(first + static_cast<std::size_t>(channel));
  }
  return value;
}

glm::vec4 centre(const FloatImage& image) {
  return pixel(image, image.size / 2);
}

glm::vec3 unpackNormal(glm::vec4 texel) {
  return glm::vec3(texel) * 2.0f - 1.0f;
}

GBuffer RendererTest::drawGBuffer(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  Renderer renderer(scene, profiler_);
  const GBufferTextures& textures = renderer.drawGeometry(camera, size);
  return {readTexture(textures.depth, size, 1),    readTexture(textures.albedo, size, 4),
          readTexture(textures.normal, size, 4),   readTexture(textures.geometricNormal, size, 4),
          readTexture(textures.material, size, 4), readTexture(textures.emissive, size, 3)};
}

FloatImage RendererTest::drawLit(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  Renderer renderer(scene, profiler_);
  renderer.drawGeometry(camera, size);
  return readTexture(renderer.drawLighting({}), size, 3);
}

}  // namespace host::test
