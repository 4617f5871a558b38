// Chandeliers in the nave and candelabra at the stairs, with candles.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addLathe;
using modelling::addSweep;

/// The parts of a lamp by material.
struct Lamp {
  Mesh metal, wax, flame;
};

Lamp makeLamp(const Hall& hall) {
  return {makeMesh("lamp metal", hall.material.bronze), makeMesh("candles", hall.material.wax),
          makeMesh("flames", hall.material.flame)};
}

void addCandle(Lamp& lamp, glm::vec3 base) {
  const std::vector<glm::vec2> cup{
      {0.0f, -0.02f}, {0.02f, -0.02f}, {0.06f, 0.015f}, {0.065f, 0.03f}, {0.0f, 0.02f}};
  addLathe(lamp.metal, base, cup, 8);
  modelling::addCylinder(lamp.wax, base + glm::vec3(0, 0.015f, 0), 0.022f, 0.02f, 0.2f, 6);
  modelling::addEllipsoid(lamp.flame, base + glm::vec3(0, 0.245f, 0), {0.012f, 0.035f, 0.012f}, {5, 3});
}

void addArm(Lamp& lamp, glm::vec3 out, float reach, float lift) {
  const std::vector<glm::vec3> path{
      0.1f * out, 0.35f * reach * out - glm::vec3(0, 0.16f, 0), 0.7f * reach * out - glm::vec3(0, 0.12f, 0),
      0.93f * reach * out + glm::vec3(0, 0.2f * lift, 0), reach * out + glm::vec3(0, lift, 0)};
  addSweep(lamp.metal, modelling::circleOutline(0.018f, 6), path, false, 80.0f);
  addCandle(lamp, reach * out + glm::vec3(0, lift, 0));
}

glm::vec3 direction(int i, int count, float offset = 0.0f) {
  const float angle = glm::two_pi<float>() * (static_cast<float>(i) + offset) / static_cast<float>(count);
  return {std::cos(angle), 0.0f, std::sin(angle)};
}

/// Two crowns of candles on a turned stem, y = 0 at the lower crown.
Lamp makeChandelier(const Hall& hall, float chain) {
  Lamp lamp = makeLamp(hall);
  const std::vector<glm::vec2> stem{{0.0f, -0.5f},  {0.05f, -0.46f}, {0.03f, -0.4f}, {0.14f, -0.28f},
                                    {0.2f, -0.12f}, {0.14f, 0.02f},  {0.06f, 0.1f},  {0.05f, 0.4f},
                                    {0.1f, 0.5f},   {0.13f, 0.62f},  {0.06f, 0.75f}, {0.03f, 0.95f},
                                    {0.0f, 1.0f}};
  addLathe(lamp.metal, {0, 0, 0}, stem, 16, 60.0f);
  constexpr int kLower = 10;
  constexpr int kUpper = 5;
  for (int i = 0; i < kLower; ++i) addArm(lamp, direction(i, kLower), 1.25f, 0.12f);
  Lamp crown = makeLamp(hall);
  for (int i = 0; i < kUpper; ++i) addArm(crown, direction(i, kUpper, 0.5f), 0.7f, 0.12f);
  const glm::mat4 raised = glm::translate(glm::mat4(1.0f), {0.0f, 0.6f, 0.0f});
  modelling::addMesh(lamp.metal, crown.metal, raised);
  modelling::addMesh(lamp.wax, crown.wax, raised);
  modelling::addMesh(lamp.flame, crown.flame, raised);
  modelling::addCylinder(lamp.metal, {0, 0.97f, 0}, 0.012f, 0.012f, chain - 0.97f, 6);
  return lamp;
}

/// A standing candelabrum with five lights.
Lamp makeCandelabrum(const Hall& hall) {
  Lamp lamp = makeLamp(hall);
  const float top = 1.6f;
  const std::vector<glm::vec2> stem{{0.24f, -kSunk - top}, {0.24f, 0.04f - top}, {0.14f, 0.09f - top},
                                    {0.06f, 0.2f - top},   {0.035f, 0.4f - top}, {0.07f, 0.48f - top},
                                    {0.03f, 0.56f - top},  {0.025f, 1.2f - top}, {0.06f, 1.28f - top},
                                    {0.03f, 1.36f - top},  {0.09f, 1.55f - top}, {0.03f, 1.62f - top},
                                    {0.02f, 0.18f}};
  addLathe(lamp.metal, {0, 0, 0}, stem, 16, 60.0f);
  for (int i = 0; i < 4; ++i) addArm(lamp, direction(i, 4, 0.5f), 0.34f, 0.06f);
  addCandle(lamp, {0.0f, 0.19f, 0.0f});
  return lamp;
}

void placeLamp(Hall& hall, Lamp lamp, std::initializer_list<glm::vec3> places) {
  for (Mesh* mesh : {&lamp.metal, &lamp.wax, &lamp.flame}) {
    const int index = hall.builder.addMesh(std::move(*mesh));
    for (const glm::vec3 place : places) hall.builder.place(index, glm::translate(glm::mat4(1.0f), place));
  }
}

}  // namespace

void addLamps(Hall& hall) {
  constexpr float kHeight = 7.6f;
  constexpr float kBossBottom = kVaultSpringing + kVaultRise - 0.4f;
  placeLamp(hall, makeChandelier(hall, kBossBottom - kHeight),
            {{0.0f, kHeight, -5.0f}, {0.0f, kHeight, 5.0f}});
  constexpr float kCandelabrumTop = 1.6f;
  placeLamp(hall, makeCandelabrum(hall),
            {{2.2f, kPlatformHeight + kCandelabrumTop, -15.4f},
             {-2.2f, kPlatformHeight + kCandelabrumTop, -15.4f}});
}

}  // namespace host::hall
