#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addLathe;
using modelling::addPatch;

constexpr int kFlutes = 16;
constexpr int kSegmentsPerFlute = 5;
constexpr float kBaseHeight = 0.52f;
constexpr float kBottomRadius = 0.4f;
constexpr float kFluteDepth = 0.04f;
constexpr float kShaftTop = kSpringing - kCapitalHeight;

/// The swelling of a shaft: the lower third straight, then a slow taper.
float shaftRadius(float t) {
  const float taper = std::clamp((t - 0.3f) / 0.7f, 0.0f, 1.0f);
  return glm::mix(kBottomRadius, kShaftTopRadius, taper * taper * (1.5f - 0.5f * taper));
}

/// Depth of the flutes around the shaft: flat fillets between hollows.
float hollow(float turn) {
  const float in = glm::fract(turn * static_cast<float>(kFlutes));
  constexpr float kHalfFillet = 0.1f;
  const float t = std::clamp((in - kHalfFillet) / (1.0f - 2.0f * kHalfFillet), 0.0f, 1.0f);
  return std::sin(glm::pi<float>() * t);
}

void addShaft(Mesh& mesh) {
  // Rows bunch where the flutes begin and end: (height along the shaft, share of the flutes' depth).
  static constexpr std::array<glm::vec2, 5> kRows{
      {{0.0f, 0.0f}, {0.025f, 1.0f}, {0.45f, 1.0f}, {0.95f, 1.0f}, {0.97f, 0.0f}}};
  static constexpr int kLast = static_cast<int>(kRows.size()) - 1;
  const auto surface = [](float u, float v) {
    const int row = std::clamp(static_cast<int>(v * kLast), 0, kLast - 1);
    const glm::vec2 at = glm::mix(kRows[row], kRows[row + 1], v * kLast - static_cast<float>(row));
    // Start in the middle of a hollow's edge, so that samples fall on the fillets' edges.
    const float turn = u + 0.1f / static_cast<float>(kFlutes);
    const float radius = shaftRadius(at.x) - kFluteDepth * at.y * hollow(turn);
    const float angle = glm::two_pi<float>() * turn;
    const float height = glm::mix(kBaseHeight, kShaftTop, at.x / 0.97f);
    return glm::vec3(radius * std::cos(angle), height, -radius * std::sin(angle));
  };
  addPatch(mesh, surface, {kFlutes * kSegmentsPerFlute, kLast});
}

/// An Attic base: square plinth, torus, scotia between fillets, smaller torus, apophyge.
void addBase(Mesh& mesh) {
  addBox(mesh, {-0.62f, -kSunk, -0.62f}, {0.62f, 0.18f, 0.62f}, 0.012f);
  std::vector<glm::vec2> profile{{0.4f, 0.17f}};
  appendArc(profile, {0.52f, 0.25f}, 0.075f, -80.0f, 80.0f, 4);
  profile.insert(profile.end(), {{0.5f, 0.325f}, {0.49f, 0.345f}});
  appendArc(profile, {0.53f, 0.385f}, 0.05f, 230.0f, 130.0f, 2);
  profile.insert(profile.end(), {{0.475f, 0.425f}});
  appendArc(profile, {0.44f, 0.46f}, 0.035f, -90.0f, 90.0f, 3);
  profile.insert(profile.end(), {{0.425f, 0.505f}, {kBottomRadius, kBaseHeight + 0.005f}});
  addLathe(mesh, {0, 0, 0}, profile, 18);
}

/// The ring between shaft and capital.
void addNecking(Mesh& mesh) {
  std::vector<glm::vec2> profile{{kShaftTopRadius - 0.01f, kShaftTop - 0.05f}};
  appendArc(profile, {kShaftTopRadius, kShaftTop - 0.015f}, 0.03f, -80.0f, 80.0f, 3);
  profile.emplace_back(kShaftTopRadius - 0.06f, kShaftTop + 0.03f);
  addLathe(mesh, {0, 0, 0}, profile, 18);
}

/// The half piers on the end walls that answer the columns.
void addResponds(Hall& hall) {
  Mesh mesh = makeMesh("respond", hall.material.dressed);
  const auto block = [&](float bottom, float top, float halfWidth, float reach) {
    addBox(mesh, {-halfWidth, bottom, -reach}, {halfWidth, top, reach}, 0.015f);
  };
  block(-kSunk, 0.3f, 0.56f, 0.66f);
  block(0.29f, kSpringing - 0.36f, 0.48f, 0.57f);
  block(kSpringing - 0.38f, kSpringing - 0.3f, 0.5f, 0.6f);
  block(kSpringing - 0.31f, kSpringing - 0.13f, 0.52f, 0.61f);
  block(kSpringing - 0.14f, kSpringing, 0.6f, 0.68f);
  const int respond = hall.builder.addMesh(std::move(mesh));
  for (const float z : {kColumnLines.front(), kColumnLines.back()})
    placeOnBothSides(hall, respond, kArcade, z);
}

}  // namespace

void addColumns(Hall& hall) {
  Mesh dressed = makeMesh("column base and capital", hall.material.dressed);
  addBase(dressed);
  addNecking(dressed);
  Mesh capital;
  addCapital(capital);
  modelling::addMesh(dressed, capital, glm::translate(glm::mat4(1.0f), {0.0f, kShaftTop, 0.0f}));
  Mesh shaft = makeMesh("column shaft", hall.material.shaft);
  addShaft(shaft);
  const int dressedIndex = hall.builder.addMesh(std::move(dressed));
  const int shaftIndex = hall.builder.addMesh(std::move(shaft));
  for (std::size_t i = 1; i + 1 < kColumnLines.size(); ++i) {
    placeOnBothSides(hall, dressedIndex, kArcade, kColumnLines[i]);
    placeOnBothSides(hall, shaftIndex, kArcade, kColumnLines[i]);
  }
  addResponds(hall);
}

}  // namespace host::hall
