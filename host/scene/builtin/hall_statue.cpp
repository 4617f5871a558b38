// A robed figure that holds up a torch, on a plinth in front of the great windows.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addEllipsoid;
using modelling::addPatch;
using modelling::addSweep;

constexpr float kFigureHeight = 2.3f;  // to the shoulders' top: larger than life

/// Half width (x) and half depth (z) of the robe at a height t = 0 (hem) to 1 (neck).
glm::vec2 robeSize(float t) {
  struct Station {
    float t;
    glm::vec2 size;
  };
  constexpr std::array<Station, 8> kStations{{{0.0f, {0.42f, 0.36f}},
                                              {0.2f, {0.34f, 0.29f}},
                                              {0.45f, {0.28f, 0.22f}},
                                              {0.62f, {0.23f, 0.18f}},
                                              {0.8f, {0.3f, 0.21f}},
                                              {0.9f, {0.29f, 0.17f}},
                                              {0.97f, {0.12f, 0.1f}},
                                              {1.0f, {0.075f, 0.08f}}}};
  std::size_t i = 1;
  while (i + 1 < kStations.size() && t > kStations[i].t) ++i;
  const Station& low = kStations[i - 1];
  const Station& high = kStations[i];
  return glm::mix(low.size, high.size, glm::smoothstep(low.t, high.t, t));
}

/// Folds hang from the belt, deepest at the hem.
glm::vec3 robe(float u, float v) {
  const float angle = glm::two_pi<float>() * u;
  const float looseness = std::clamp(1.0f - v / 0.66f, 0.0f, 1.0f);
  const float folds =
      1.0f + looseness * (0.09f * std::sin(11.0f * angle + 3.0f * v) + 0.05f * std::sin(5.0f * angle)) +
      (v > 0.66f ? 0.02f * std::sin(8.0f * angle + 12.0f * v) : 0.0f);
  const glm::vec2 size = robeSize(v) * folds;
  const float sway = 0.05f * std::sin(glm::pi<float>() * v);
  return {size.x * std::cos(angle) + sway, kFigureHeight * v, -size.y * std::sin(angle)};
}

void addFigure(Mesh& mesh) {
  addPatch(mesh, robe, {50, 22});
  addBox(mesh, {-0.44f, -0.1f, -0.38f}, {0.44f, 0.03f, 0.38f}, 0.03f);
  addEllipsoid(mesh, {0.0f, kFigureHeight + 0.02f, 0.0f}, {0.065f, 0.12f, 0.07f}, {16, 8});     // neck
  addEllipsoid(mesh, {0.0f, kFigureHeight + 0.22f, 0.02f}, {0.115f, 0.16f, 0.135f}, {18, 12});  // head
  addEllipsoid(mesh, {0.0f, kFigureHeight + 0.27f, -0.03f}, {0.13f, 0.14f, 0.13f}, {18, 10});   // hair
  const auto limb = [&](const std::vector<glm::vec3>& path, float radius) {
    addSweep(mesh, modelling::circleOutline(radius, 12), path, false, 60.0f, {0, 0, 1});
  };
  // The right arm raises a torch; the left holds a scroll against the hip.
  limb({{0.26f, 2.02f, 0.0f}, {0.42f, 2.2f, 0.03f}, {0.5f, 2.5f, 0.08f}, {0.46f, 2.78f, 0.12f}}, 0.06f);
  limb({{0.455f, 2.55f, 0.12f}, {0.46f, 3.05f, 0.13f}}, 0.028f);
  limb({{-0.26f, 2.02f, 0.0f}, {-0.38f, 1.75f, 0.02f}, {-0.36f, 1.48f, 0.12f}, {-0.22f, 1.42f, 0.24f}},
       0.06f);
  limb({{-0.24f, 1.2f, 0.26f}, {-0.2f, 1.62f, 0.27f}}, 0.05f);
  const std::vector<glm::vec2> bowl{{0.03f, 0.0f},  {0.1f, 0.06f},  {0.12f, 0.1f},
                                    {0.06f, 0.12f}, {0.07f, 0.18f}, {0.0f, 0.34f}};
  modelling::addLathe(mesh, {0.46f, 3.03f, 0.13f}, bowl, 14);
}

void addPlinth(Mesh& mesh) {
  const auto block = [&](float bottom, float top, float halfWidth, float bevel) {
    addBox(mesh, {-halfWidth, bottom, -halfWidth}, {halfWidth, top, halfWidth}, bevel);
  };
  block(-kSunk, 0.16f, 0.78f, 0.02f);
  block(0.15f, 0.24f, 0.7f, 0.03f);
  block(0.23f, 0.98f, 0.6f, 0.02f);
  block(0.97f, 1.06f, 0.66f, 0.03f);
  block(1.05f, 1.17f, 0.74f, 0.03f);
}

}  // namespace

void addStatue(Hall& hall) {
  Mesh plinth = makeMesh("statue plinth", hall.material.redMarble);
  addPlinth(plinth);
  Mesh figure = makeMesh("statue", hall.material.paleMarble);
  addFigure(figure);
  const glm::vec3 place(0.0f, kPlatformHeight, -15.9f);
  hall.builder.place(hall.builder.addMesh(std::move(plinth)), glm::translate(glm::mat4(1.0f), place));
  hall.builder.place(hall.builder.addMesh(std::move(figure)),
                     glm::translate(glm::mat4(1.0f), place + glm::vec3(0.0f, 1.25f, 0.0f)));
}

}  // namespace host::hall
