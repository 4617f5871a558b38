#include <array>
#include <cmath>

#include "host/scene/builtin/furniture_seats.h"
#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

constexpr int kArms = 5;
constexpr float kArmLength = 0.3f;
constexpr float kWheelRadius = 0.027f;

// A wheel under its hood below the end of an arm, swivelled by `degrees`.
void addCaster(Piece& chair, glm::vec3 pivot, float degrees) {
  Piece caster("caster");
  addRod(caster.part(Finish::blackPlastic), {-0.02f, kWheelRadius, -0.014f}, {0.02f, kWheelRadius, -0.014f},
         kWheelRadius, 8);
  modelling::addBox(caster.part(Finish::greyPlastic), {-0.024f, 0.032f, -0.03f}, {0.024f, pivot.y, 0.012f});
  chair.add(caster, at({pivot.x, 0.0f, pivot.z}, degrees));
}

void addBase(Piece& chair) {
  // An arm seen from the side: deep at the hub, thin at the tip.
  const std::array<glm::vec2, 6> side{
      glm::vec2(0.0f, 0.075f),      {0.2f, 0.066f},  {kArmLength + 0.02f, 0.058f},
      {kArmLength + 0.02f, 0.076f}, {0.18f, 0.098f}, {0.0f, 0.125f}};
  constexpr float kWidth = 0.042f;
  for (int i = 0; i < kArms; ++i) {
    const float degrees = 360.0f / kArms * static_cast<float>(i) + 18.0f;
    Mesh& arm = chair.part(Finish::blackPlastic);
    const std::size_t first = arm.vertices.size();
    modelling::addExtrusion(arm, side, kWidth);
    modelling::transformFrom(arm, first, turned(degrees, {0, 1, 0}) * at({0.0f, 0.0f, -kWidth * 0.5f}));
    const float angle = glm::radians(degrees);
    addCaster(chair, {kArmLength * std::cos(angle), 0.062f, -kArmLength * std::sin(angle)},
              degrees * 1.7f + 40.0f * static_cast<float>(i));
  }
  modelling::addCylinder(chair.part(Finish::blackPlastic), {0, 0.07f, 0}, 0.044f, 0.034f, 0.07f, 10);
  modelling::addCylinder(chair.part(Finish::blackPlastic), {0, 0.135f, 0}, 0.025f, 0.025f, 0.13f, 10);
  modelling::addCylinder(chair.part(Finish::chrome), {0, 0.26f, 0}, 0.014f, 0.014f, 0.16f, 8);
}

void addSeat(Piece& chair) {
  modelling::addBox(chair.part(Finish::blackPlastic), {-0.09f, 0.405f, -0.13f}, {0.09f, 0.45f, 0.1f});
  addRod(chair.part(Finish::blackPlastic), {0.08f, 0.425f, 0.04f}, {0.21f, 0.415f, 0.05f}, 0.006f, 4);
  const auto seat = [](float u, float v) {
    glm::vec3 p = superellipsoid({0.245f, 0.038f, 0.235f}, {0.42f, 0.55f}, u, v);
    const float front = std::max(p.z - 0.1f, 0.0f);
    p.y -= 1.6f * front * front;           // waterfall edge
    p.y += 0.5f * p.x * p.x * (1.0f - v);  // dished underside and top
    return p + glm::vec3(0.0f, 0.482f, 0.02f);
  };
  modelling::addPatch(chair.part(Finish::chairFabric), seat, {12, 6});
}

void addBackrest(Piece& chair) {
  // The spine rises from under the seat; the back wraps around the sitter and leans back.
  const std::array<glm::vec3, 5> spine{glm::vec3(0, 0.43f, -0.1f),
                                       {0, 0.43f, -0.24f},
                                       {0, 0.46f, -0.29f},
                                       {0, 0.55f, -0.305f},
                                       {0, 0.8f, -0.34f}};
  modelling::addSweep(chair.part(Finish::blackPlastic), modelling::rectangleOutline(0.06f, 0.016f), spine);
  const auto back = [](float u, float v) {
    glm::vec3 p = superellipsoid({0.225f, 0.28f, 0.03f}, {0.6f, 0.42f}, u, v);
    p.x *= 1.0f - 0.35f * std::max(p.y, 0.0f);
    p.z += 0.9f * p.x * p.x + 0.05f * std::cos(7.0f * (p.y + 0.1f)) - 0.17f * p.y;
    return p + glm::vec3(0.0f, 0.86f, -0.325f);
  };
  modelling::addPatch(chair.part(Finish::chairFabric), back, {12, 7});
}

void addArmrests(Piece& chair) {
  for (const float side : {-1.0f, 1.0f}) {
    Mesh& plastic = chair.part(Finish::blackPlastic);
    const std::array<glm::vec3, 4> bracket{glm::vec3(side * 0.06f, 0.428f, -0.02f),
                                           {side * 0.26f, 0.428f, -0.02f},
                                           {side * 0.285f, 0.46f, -0.02f},
                                           {side * 0.285f, 0.655f, -0.02f}};
    modelling::addSweep(plastic, modelling::rectangleOutline(0.014f, 0.05f), bracket, false, 40.0f,
                        {0, 0, 1});
    const std::size_t first = plastic.vertices.size();
    addRoundedBoard(plastic, {0.075f, 0.25f}, 0.03f, 0.65f, 0.028f, 2);
    modelling::transformFrom(plastic, first, at({side * 0.28f, 0.0f, 0.01f}));
  }
}

}  // namespace

Piece officeChair() {
  Piece chair("office chair");
  addBase(chair);
  addSeat(chair);
  addBackrest(chair);
  addArmrests(chair);
  return chair;
}

}  // namespace host::furniture
