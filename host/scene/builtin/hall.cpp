// A grand hall: a vaulted nave of seven bays between two-storeyed arcades, aisles, galleries, stairs at the
// far end.
#include "host/scene/builtin/builtin_scenes.h"
#include "host/scene/builtin/hall_parts.h"

namespace host {
namespace {

/// A low sun on the side of +x shines through the aisles' and the galleries' windows.
Light sun() {
  Light light;
  light.name = "sun";
  light.type = LightType::directional;
  light.color = {1.0f, 0.86f, 0.66f};
  light.intensity = 7.0f;
  light.direction = glm::normalize(glm::vec3(-1.0f, -0.4f, -0.16f));
  return light;
}

std::vector<Camera> cameras() {
  return {
      lookAt("nave", {0.9f, 1.75f, 16.2f}, {-0.3f, 4.6f, -10.0f}, 62.0f),
      lookAt("gallery", {6.2f, 9.0f, 11.1f}, {-2.6f, 2.6f, -4.0f}, 60.0f),
      lookAt("capital", {-4.35f, 3.4f, -0.75f}, {-5.9f, 4.05f, -2.55f}, 46.0f),
      lookAt("balusters", {3.1f, 2.42f, -14.75f}, {10.4f, 3.3f, -15.25f}, 52.0f),
      lookAt("floor", {2.7f, 0.35f, 12.0f}, {-0.9f, 1.5f, -4.0f}, 55.0f),
      lookAt("vaults", {0.6f, 1.7f, 3.5f}, {-0.2f, 12.0f, -5.0f}, 65.0f),
      lookAt("stairs", {-3.3f, 1.7f, -3.6f}, {1.2f, 2.6f, -15.0f}, 58.0f),
      lookAt("aisle", {-9.3f, 1.65f, 11.6f}, {-0.5f, 3.2f, -3.5f}, 60.0f),
  };
}

}  // namespace

Scene makeHall() {
  hall::Hall hall;
  hall.material = hall::addMaterials(hall.builder);
  hall::addShell(hall);
  hall::addEndWalls(hall);
  hall::addDoors(hall);
  hall::addArcades(hall);
  hall::addColumns(hall);
  hall::addVaults(hall);
  hall::addWindows(hall);
  hall::addBalustrades(hall);
  hall::addStairs(hall);
  hall::addFurnishing(hall);
  hall::addStatue(hall);
  hall::addLamps(hall);
  Scene scene = hall.builder.take();
  scene.lights = {sun()};
  scene.cameras = cameras();
  return scene;
}

}  // namespace host
