#include "host/scene/scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <stdexcept>

#include "host/scene/auto_cameras.h"
#include "host/scene/builtin/builtin_scenes.h"
#include "host/scene/camera_file.h"
#include "host/scene/gltf/gltf_loader.h"

namespace host {
namespace {

struct BuiltinScene {
  const char* name;
  Scene (*make)();
};

constexpr std::array kBuiltinScenes = {BuiltinScene{"office", makeOffice}, BuiltinScene{"hall", makeHall},
                                       BuiltinScene{"breakfast", makeBreakfast}};

bool looksLikePath(const std::string& text) {
  std::string extension = std::filesystem::path(text).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  std::error_code ignored;
  return extension == ".gltf" || extension == ".glb" || text.find('/') != std::string::npos ||
         std::filesystem::exists(text, ignored);
}

/// The strength that Blender and most viewers give a new sun, from the upper left behind the viewer.
Light defaultSun() {
  Light sun;
  sun.name = "sun";
  sun.direction = glm::normalize(glm::vec3(-0.45f, -1.0f, -0.35f));
  sun.color = {1.0f, 0.96f, 0.9f};
  sun.intensity = 3.0f;
  return sun;
}

/// Gives a file what it need not have but a picture needs, and the cameras that users put beside it.
Scene completed(Scene scene, const std::string& path) {
  if (triangleCount(scene) == 0) {
    throw std::runtime_error(
        fmt::format("'{}' has nothing to draw: no triangles in its scene; name another file", path));
  }
  if (auto cameras = camerasBeside(path, boundsOf(scene))) scene.cameras = std::move(*cameras);
  if (scene.cameras.empty()) scene.cameras = automaticCameras(scene);
  if (scene.lights.empty()) scene.lights.push_back(defaultSun());
  return scene;
}

}  // namespace

std::size_t triangleCount(const Scene& scene) {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) {
    count += scene.meshes[std::size_t(instance.mesh)].indices.size() / 3;
  }
  return count;
}

Bounds boundsOf(const Scene& scene) {
  if (triangleCount(scene) == 0) return {glm::vec3(-0.5f), glm::vec3(0.5f)};
  Bounds bounds{glm::vec3(std::numeric_limits<float>::max()),
                glm::vec3(std::numeric_limits<float>::lowest())};
  for (const Instance& instance : scene.instances) {
    for (const Vertex& vertex : scene.meshes[std::size_t(instance.mesh)].vertices) {
      const glm::vec3 position(instance.transform * glm::vec4(vertex.position, 1.0f));
      bounds.min = glm::min(bounds.min, position);
      bounds.max = glm::max(bounds.max, position);
    }
  }
  return bounds;
}

Camera lookAt(std::string name, glm::vec3 position, glm::vec3 target, float verticalFovDegrees) {
  const glm::vec3 offset = target - position;
  const glm::vec3 direction =
      glm::length(offset) > 0.0f ? glm::normalize(offset) : glm::vec3(0.0f, 0.0f, -1.0f);
  // Straight up or down, +Y says nothing; then the top of the picture is where north is on a map.
  const bool isVertical = std::abs(direction.y) > 0.9999f;
  const glm::vec3 up = isVertical ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  Camera camera;
  camera.name = std::move(name);
  camera.position = position;
  camera.orientation = glm::quatLookAt(direction, up);
  camera.verticalFov = glm::radians(verticalFovDegrees);
  return camera;
}

glm::mat4 viewMatrix(const Camera& camera) {
  return glm::mat4_cast(glm::conjugate(camera.orientation)) *
         glm::translate(glm::mat4(1.0f), -camera.position);
}

glm::mat4 projectionMatrix(const Camera& camera, float aspect) {
  if (camera.orthographicHeight) {
    const float top = *camera.orthographicHeight * 0.5f;
    const float right = top * aspect;
    return glm::ortho(-right, right, -top, top, camera.nearPlane, camera.farPlane);
  }
  if (camera.farPlane == 0.0f) return glm::infinitePerspective(camera.verticalFov, aspect, camera.nearPlane);
  return glm::perspective(camera.verticalFov, aspect, camera.nearPlane, camera.farPlane);
}

Scene loadScene(const std::string& nameOrPath) {
  for (const BuiltinScene& builtin : kBuiltinScenes) {
    if (nameOrPath == builtin.name) return builtin.make();
  }
  if (!looksLikePath(nameOrPath)) {
    throw std::runtime_error(
        fmt::format("there is no scene '{}'; use one of {}, or the path of a .gltf or .glb file", nameOrPath,
                    fmt::join(builtinSceneNames(), ", ")));
  }
  return completed(loadGltf(nameOrPath), nameOrPath);
}

const std::vector<std::string>& builtinSceneNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    names.reserve(kBuiltinScenes.size());
    for (const BuiltinScene& builtin : kBuiltinScenes) names.emplace_back(builtin.name);
    return names;
  }();
  return kNames;
}

}  // namespace host
