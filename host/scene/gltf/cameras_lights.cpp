#include "host/scene/gltf/cameras_lights.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "host/scene/clip_planes.h"
#include "host/scene/gltf/properties.h"

namespace host::gltf {
namespace {

/// The rotation of a transform that may scale, shear and mirror: -Z and +Y as they look in the world.
std::optional<glm::quat> orientationOf(const glm::mat4& transform) {
  const glm::dvec3 back(transform[2]);
  const glm::dvec3 right = glm::cross(glm::dvec3(transform[1]), back);
  if (!(glm::length(back) > 0.0) || !(glm::length(right) > 0.0)) return std::nullopt;
  const glm::dvec3 z = glm::normalize(back);
  const glm::dvec3 x = glm::normalize(right);
  return glm::normalize(glm::quat_cast(glm::mat3(glm::vec3(x), glm::vec3(glm::cross(z, x)), glm::vec3(z))));
}

bool setPerspective(Camera& camera, const tinygltf::PerspectiveCamera& source) {
  camera.verticalFov = toFloat(source.yfov);
  camera.nearPlane = toFloat(source.znear);
  camera.farPlane = toFloat(source.zfar);  // tinygltf leaves it 0 where it is missing: infinitely far
  return camera.verticalFov > 0.0f && camera.verticalFov < glm::pi<float>();
}

/// The aspect ratio is the picture's, so only the height counts.
bool setOrthographic(Camera& camera, const tinygltf::OrthographicCamera& source) {
  camera.orthographicHeight = 2.0f * std::abs(toFloat(source.ymag));
  camera.nearPlane = toFloat(source.znear);
  camera.farPlane = toFloat(source.zfar);
  return *camera.orthographicHeight > 0.0f;
}

bool clipPlanesWork(const Camera& camera) {
  if (camera.orthographicHeight) return camera.nearPlane >= 0.0f && camera.farPlane > camera.nearPlane;
  return camera.nearPlane > 0.0f && (camera.farPlane == 0.0f || camera.farPlane > camera.nearPlane);
}

void setSpot(Light& light, const tinygltf::SpotLight& source) {
  const float outer = toFloat(source.outerConeAngle);
  const float inner = toFloat(source.innerConeAngle);
  if (outer > 0.0f && outer <= glm::half_pi<float>()) light.outerConeAngle = outer;
  light.innerConeAngle = std::clamp(inner, 0.0f, light.outerConeAngle);
}

std::optional<LightType> toLightType(const std::string& type) {
  if (type == "directional") return LightType::directional;
  if (type == "point") return LightType::point;
  if (type == "spot") return LightType::spot;
  return std::nullopt;
}

}  // namespace

std::optional<Camera> convertCamera(Document& document, const PlacedNode& placed, const Bounds& bounds) {
  const int index = placed.node->camera;
  if (index == -1) return std::nullopt;
  const auto leaveOut = [&](const char* why) {
    document.warnings.push_back(fmt::format("Camera {} is left out: {}.", index, why));
    return std::nullopt;
  };
  if (index < 0 || std::size_t(index) >= document.model.cameras.size()) return leaveOut("it does not exist");
  const tinygltf::Camera& source = document.model.cameras[std::size_t(index)];
  const auto orientation = orientationOf(placed.transform);
  if (!orientation) return leaveOut("its node has no direction");

  Camera camera;
  camera.name = source.name.empty() ? placed.node->name : source.name;
  camera.position = glm::vec3(placed.transform[3]);
  camera.orientation = *orientation;
  const bool isOrthographic = source.type == "orthographic";
  const bool isValid = isOrthographic ? setOrthographic(camera, source.orthographic)
                                      : setPerspective(camera, source.perspective);
  if (!isValid) return leaveOut("its field of view is impossible");
  if (!clipPlanesWork(camera)) fitClipPlanes(camera, bounds);
  return camera;
}

std::optional<Light> convertLight(Document& document, const PlacedNode& placed) {
  const tinygltf::Value* extension = findExtension(placed.node->extensions, "KHR_lights_punctual");
  if (extension == nullptr) return std::nullopt;
  const int index = integerMember(*extension, "light", -1);
  const auto leaveOut = [&](const char* why) {
    document.warnings.push_back(fmt::format("Light {} is left out: {}.", index, why));
    return std::nullopt;
  };
  if (index < 0 || std::size_t(index) >= document.model.lights.size()) return leaveOut("it does not exist");
  const tinygltf::Light& source = document.model.lights[std::size_t(index)];
  const auto type = toLightType(source.type);
  const auto orientation = orientationOf(placed.transform);
  if (!type) return leaveOut("its type is unknown");
  if (!orientation) return leaveOut("its node has no direction");

  Light light;
  light.name = source.name.empty() ? placed.node->name : source.name;
  light.type = *type;
  light.color = glm::max(toVec3(source.color, glm::vec3(1.0f)), 0.0f);
  light.intensity = std::max(toFloat(source.intensity), 0.0f);
  light.range = std::max(toFloat(source.range), 0.0f);
  light.position = glm::vec3(placed.transform[3]);
  light.direction = *orientation * glm::vec3(0.0f, 0.0f, -1.0f);
  if (light.type == LightType::spot) setSpot(light, source.spot);
  return light;
}

}  // namespace host::gltf
