#include "host/scene/camera_file.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "host/scene/clip_planes.h"

namespace host {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

constexpr float kUsualFov = 50.0f;
constexpr float kSmallestFov = 1.0f;
constexpr float kLargestFov = 170.0f;

glm::vec3 pointOf(const Json& camera, const char* name) {
  const Json point = camera.value(name, Json());
  if (!point.is_array() || point.size() != 3)
    throw std::runtime_error(fmt::format("needs a '{}' of three numbers", name));
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) {
    const Json& coordinate = point[static_cast<std::size_t>(i)];
    result[i] = coordinate.is_number() ? coordinate.get<float>() : NAN;
    if (!std::isfinite(result[i]))
      throw std::runtime_error(fmt::format("has a '{}' that is no number: {}", name, coordinate.dump()));
  }
  return result;
}

float fovOf(const Json& camera) {
  const Json fov = camera.value("vertical_fov", Json(kUsualFov));
  const float degrees = fov.is_number() ? fov.get<float>() : NAN;
  if (!(degrees >= kSmallestFov && degrees <= kLargestFov))
    throw std::runtime_error(fmt::format("has a 'vertical_fov' of {}; give {} to {} degrees", fov.dump(),
                                         kSmallestFov, kLargestFov));
  return degrees;
}

std::string nameOf(const Json& camera) {
  const Json name = camera.value("name", Json(""));
  if (!name.is_string()) throw std::runtime_error("has a 'name' that is no text");
  return name.get<std::string>();
}

Camera cameraOf(const Json& json, const Bounds& bounds) {
  if (!json.is_object()) throw std::runtime_error("is no object");
  const glm::vec3 position = pointOf(json, "position");
  const glm::vec3 target = pointOf(json, "target");
  if (position == target) throw std::runtime_error("looks at where it stands");
  Camera camera = lookAt(nameOf(json), position, target, fovOf(json));
  fitClipPlanes(camera, bounds);
  return camera;
}

std::vector<Camera> camerasOf(const Json& list, const Bounds& bounds) {
  if (!list.is_array() || list.empty()) throw std::runtime_error("it is no JSON list of cameras");
  std::vector<Camera> cameras;
  cameras.reserve(list.size());
  for (const Json& json : list) {
    try {
      cameras.push_back(cameraOf(json, bounds));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("camera {} {}", cameras.size(), error.what()));
    }
  }
  return cameras;
}

}  // namespace

std::optional<std::vector<Camera>> camerasBeside(const fs::path& scene, const Bounds& bounds) {
  const fs::path file = fs::path(scene).replace_extension(".cameras.json");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  try {
    std::ifstream stream(file);
    return camerasOf(Json::parse(stream, nullptr, false), bounds);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("can't take the cameras of '{}': {}", file.string(), error.what()));
  }
}

}  // namespace host
