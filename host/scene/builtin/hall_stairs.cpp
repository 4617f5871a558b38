// A flight of stairs over the nave's width up to a platform below the great windows, with balustrades and
// newels.
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;

constexpr float kStairFoot = kPlatformFront + kTread * kSteps;
constexpr float kBalustradeX = kStairHalfWidth + 0.14f;
constexpr float kNosing = 0.03f;
constexpr int kSegments = 10;  // of the balusters

/// (distance from the platform's front, height): steps with projecting nosings.
std::vector<glm::vec2> stepsOutline() {
  std::vector<glm::vec2> outline{{-0.2f, -kSunk}, {kTread * kSteps, -kSunk}};
  for (int step = 0; step < kSteps; ++step) {
    const float riser = kTread * static_cast<float>(kSteps - step);
    const float top = kRiser * static_cast<float>(step + 1);
    outline.insert(outline.end(), {{riser, top - 0.045f},
                                   {riser + kNosing - 0.008f, top - 0.04f},
                                   {riser + kNosing, top - 0.02f},
                                   {riser + kNosing - 0.008f, top - 0.003f},
                                   {riser + kNosing - 0.022f, top}});
    if (step + 1 < kSteps) outline.emplace_back(riser - kTread, top);
  }
  outline.emplace_back(-0.2f, kPlatformHeight);
  return outline;
}

void addSteps(Mesh& mesh) {
  const std::size_t first = mesh.vertices.size();
  modelling::addExtrusion(mesh, stepsOutline(), 2.0f * kStairHalfWidth, 50.0f);
  // The outline's x runs along +z from the platform's front, its extrusion along -x.
  const glm::mat4 placed = glm::translate(glm::mat4(1.0f), {kStairHalfWidth, -0.001f, kPlatformFront});
  modelling::transformFrom(mesh, first, glm::rotate(placed, -glm::half_pi<float>(), {0, 1, 0}));
}

/// The solid strings on both sides of the steps.
void addStrings(Mesh& mesh) {
  const float foot = kTread * kSteps + 0.1f;
  const std::vector<glm::vec2> outline{
      {0.0f, -kSunk}, {foot, -kSunk}, {foot, 0.24f}, {0.0f, kPlatformHeight + 0.1f}};
  for (const float x : {-kStairHalfWidth + 0.02f, kStairHalfWidth + 0.3f}) {
    const std::size_t first = mesh.vertices.size();
    modelling::addExtrusion(mesh, outline, 0.32f);
    const glm::mat4 placed = glm::translate(glm::mat4(1.0f), {x, 0.0f, kPlatformFront});
    modelling::transformFrom(mesh, first, glm::rotate(placed, -glm::half_pi<float>(), {0, 1, 0}));
  }
}

/// A square pedestal that ends a balustrade, with an urn.
void addNewel(Mesh& mesh, glm::vec3 base) {
  const auto block = [&](float bottom, float top, float halfWidth, float bevel) {
    addBox(mesh, base + glm::vec3(-halfWidth, bottom, -halfWidth),
           base + glm::vec3(halfWidth, top, halfWidth), bevel);
  };
  block(-kSunk, 0.14f, 0.27f, 0.0f);
  block(0.13f, 0.98f, 0.22f, 0.0f);
  block(0.97f, 1.03f, 0.25f, 0.0f);
  block(1.02f, 1.1f, 0.29f, 0.02f);
  for (const float turn : {0.0f, 1.0f, 2.0f, 3.0f}) {  // sunk panels would vanish at a distance: raised ones
    const std::size_t first = mesh.vertices.size();
    addBox(mesh, {-0.14f, 0.24f, 0.2f}, {0.14f, 0.88f, 0.24f});
    modelling::transformFrom(
        mesh, first,
        glm::rotate(glm::translate(glm::mat4(1.0f), base), turn * glm::half_pi<float>(), {0, 1, 0}));
  }
  addUrn(mesh, base + glm::vec3(0.0f, 1.1f, 0.0f), 0.62f);
}

void addStairBalustrades(Mesh& mesh) {
  const float edge = kPlatformHalfWidth - 0.14f;
  for (const float side : {-1.0f, 1.0f}) {
    const float x = side * kBalustradeX;
    const glm::vec3 top(x, kPlatformHeight, kPlatformFront - 0.14f);
    const glm::vec3 foot(x, 0.0f, kStairFoot + 0.22f);
    addNewel(mesh, top);
    addNewel(mesh, foot);
    const glm::vec3 upperEnd(x, kPlatformHeight + 0.06f, kPlatformFront + 0.05f);
    const glm::vec3 lowerEnd(x, 0.2f, kStairFoot + 0.04f);
    addBalustradeRun(mesh, lowerEnd, upperEnd, kSteps, kSegments);

    const glm::vec3 corner(side * edge, kPlatformHeight, kPlatformFront - 0.14f);
    addBalustradeRun(mesh, top + glm::vec3(side * 0.2f, 0, 0), corner - glm::vec3(side * 0.2f, 0, 0), 4,
                     kSegments);
    addNewel(mesh, corner);
    addBalustradeRun(mesh, corner - glm::vec3(0, 0, 0.2f),
                     {side * edge, kPlatformHeight, -kHalfLength - kSunk}, 10, kSegments);
  }
}

}  // namespace

void addStairs(Hall& hall) {
  Mesh platform = makeMesh("platform", hall.material.ashlar);
  addBox(platform, {-kPlatformHalfWidth, -kSunk, -kHalfLength - 0.05f},
         {kPlatformHalfWidth, kPlatformHeight - 0.05f, kPlatformFront});
  addStrings(platform);
  Mesh slab = makeMesh("platform floor", hall.material.floor);
  addBox(slab, {-kPlatformHalfWidth - 0.05f, kPlatformHeight - 0.07f, -kHalfLength - 0.05f},
         {kPlatformHalfWidth + 0.05f, kPlatformHeight, kPlatformFront + 0.012f}, 0.01f);
  Mesh steps = makeMesh("steps", hall.material.dressed);
  addSteps(steps);
  Mesh balustrade = makeMesh("stair balustrade", hall.material.paleMarble);
  addStairBalustrades(balustrade);
  for (Mesh* mesh : {&platform, &slab, &steps, &balustrade}) {
    hall.builder.place(hall.builder.addMesh(std::move(*mesh)));
  }
}

}  // namespace host::hall
