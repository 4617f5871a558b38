#include "host/scene/builtin/furniture_plants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

// Phyllotaxis: each leaf is turned by the golden angle from the one before.
constexpr float kGoldenAngle = 2.3999632f;

// A leaf from the origin along +Z, its upper side up: pointed, folded along the midrib, arching down to its
// tip.
Mesh leafMesh(glm::vec2 size, float arch, glm::ivec2 segments) {
  Mesh mesh;
  const auto blade = [&](float u, float v) {
    const float across = 2.0f * u - 1.0f;
    // Blunt at both ends: a point would leave its normals undefined.
    const float outline = std::max(std::sin(glm::pi<float>() * std::pow(v, 0.8f)), 0.04f);
    const float x = across * 0.5f * size.x * outline;
    const float fold = 0.35f * std::abs(x);
    const float ripple =
        0.04f * size.x * outline * outline * across * across * std::sin(14.0f * v + 2.0f * across);
    return glm::vec3(-x, fold + ripple - arch * v * v, size.y * (v - 0.25f * arch * v * v));
  };
  modelling::addPatch(mesh, blade, segments);
  return mesh;
}

// The frame at `position` whose +Z is `forward`, leaning up.
glm::mat4 facing(glm::vec3 position, glm::vec3 forward) {
  const glm::vec3 z = glm::normalize(forward);
  const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), z));
  return {glm::vec4(x, 0.0f), glm::vec4(glm::cross(z, x), 0.0f), glm::vec4(z, 0.0f),
          glm::vec4(position, 1.0f)};
}

glm::vec3 around(float angle) {
  return {std::cos(angle), 0.0f, std::sin(angle)};
}

void addPot(Piece& plant, float radius, float height, Finish finish, int segments) {
  const float r = radius;
  const float h = height;
  const std::array<glm::vec2, 8> profile{
      glm::vec2(0.0f, 0.0f),   {0.73f * r, 0.0f}, {0.92f * r, 0.8f * h}, {1.02f * r, 0.82f * h},
      {1.02f * r, h - 0.006f}, {1.0f * r, h},     {0.9f * r, h},         {0.86f * r, 0.82f * h}};
  modelling::addLathe(plant.part(finish), glm::vec3(0.0f), profile, segments);
  const std::array<glm::vec2, 2> earth{glm::vec2(0.9f * r, 0.86f * h), {0.0f, 0.91f * h}};
  modelling::addLathe(plant.part(Finish::soil), glm::vec3(0.0f), earth, segments);
}

class PlantBuilder {
 public:
  explicit PlantBuilder(const PlantShape& shape)
      : shape_(shape), random_(shape.seed), potHeight_(1.5f * shape.potRadius), plant_("potted plant") {}

  Piece build() {
    addPot(plant_, shape_.potRadius, potHeight_, shape_.pot, shape_.potSegments);
    for (int stem = 0; stem < shape_.stems; ++stem) addStem(stem);
    return std::move(plant_);
  }

 private:
  void addStem(int stem) {
    const float turn = glm::two_pi<float>() * static_cast<float>(stem) / static_cast<float>(shape_.stems) +
                       random_.between(-0.4f, 0.4f);
    const float rise = (shape_.height - potHeight_) * random_.between(0.68f, 0.95f);
    const float spread = rise * random_.between(0.14f, 0.42f);
    const float base = 0.85f * potHeight_;
    const glm::vec3 out = around(turn);
    const float thick = 0.0035f + 0.004f * shape_.height;
    const std::array<TubePoint, 4> line{
        TubePoint{out * (0.3f * shape_.potRadius) + glm::vec3(0, base, 0), thick},
        {out * (0.3f * spread) + glm::vec3(0, base + 0.35f * rise, 0), 0.8f * thick},
        {out * (0.6f * spread) + glm::vec3(0, base + 0.7f * rise, 0), 0.6f * thick},
        {out * spread + glm::vec3(0, base + rise, 0), 0.25f * thick}};
    addTube(plant_.part(Finish::stem), line, shape_.stemSegments);
    for (int leaf = 0; leaf < shape_.leavesPerStem; ++leaf) addLeaf(line, leaf, turn);
  }

  void addLeaf(std::span<const TubePoint> stem, int leaf, float turn) {
    const float t =
        0.3f + 0.7f * (static_cast<float>(leaf) + 0.5f) / static_cast<float>(shape_.leavesPerStem);
    const glm::vec3 foot = alongCurve(stem, t).position;
    const float angle = turn + kGoldenAngle * static_cast<float>(leaf) + random_.between(-0.3f, 0.3f);
    const float lift = glm::mix(0.25f, 1.1f, t) + random_.between(-0.25f, 0.25f);
    const glm::vec3 forward = around(angle) + glm::vec3(0.0f, lift, 0.0f);
    const float scale = random_.between(0.75f, 1.1f) * glm::mix(1.0f, 0.65f, t);
    const float stalk = 0.22f * shape_.leafLength * scale;
    const glm::vec3 bladeFoot = foot + glm::normalize(forward) * stalk;
    addRod(plant_.part(Finish::stem), foot, bladeFoot, 0.006f * shape_.leafLength + 0.0006f, 3);
    const glm::vec2 size = glm::vec2(shape_.leafWidth, shape_.leafLength) * scale;
    const Mesh blade = leafMesh(size, shape_.leafLength * random_.between(0.25f, 0.6f), shape_.leafSegments);
    modelling::addMesh(plant_.part(shape_.leaves), blade, facing(bladeFoot, forward));
  }

  PlantShape shape_;
  Random random_;
  float potHeight_;
  Piece plant_;
};

// A rose-like flower about the origin: whorls of cupped petals, the inner ones steeper.
Piece flower() {
  Piece piece("flower");
  for (int whorl = 0; whorl < 3; ++whorl) {
    const int petals = 4 + whorl;
    for (int i = 0; i < petals; ++i) {
      const float size = 0.02f + 0.006f * static_cast<float>(whorl);
      const Mesh petal =
          leafMesh({size * 1.3f, size * 1.25f}, -0.014f + 0.006f * static_cast<float>(whorl), {3, 4});
      const float angle = glm::two_pi<float>() * (static_cast<float>(i) + 0.4f * static_cast<float>(whorl)) /
                          static_cast<float>(petals);
      const glm::vec3 up(0.0f, 1.9f - 0.7f * static_cast<float>(whorl), 0.0f);
      modelling::addMesh(piece.part(Finish::petal), petal,
                         facing(around(angle) * 0.002f, around(angle) + up));
    }
  }
  modelling::addEllipsoid(piece.part(Finish::lemon), {0, 0.006f, 0}, {0.005f, 0.005f, 0.005f}, {8, 6});
  return piece;
}

}  // namespace

Piece pottedPlant(const PlantShape& shape) {
  return PlantBuilder(shape).build();
}

Piece vaseWithFlowers(int flowers, std::uint32_t seed) {
  Piece piece("vase with flowers");
  Random random(seed);
  const std::array<glm::vec2, 17> vase{
      glm::vec2(0.0f, 0.003f), {0.034f, 0.003f}, {0.036f, 0.0f},   {0.042f, 0.0f},   {0.044f, 0.006f},
      {0.06f, 0.04f},          {0.068f, 0.08f},  {0.064f, 0.12f},  {0.046f, 0.165f}, {0.035f, 0.19f},
      {0.034f, 0.205f},        {0.042f, 0.222f}, {0.044f, 0.224f}, {0.041f, 0.225f}, {0.032f, 0.206f},
      {0.032f, 0.19f},         {0.03f, 0.17f}};
  modelling::addLathe(piece.part(Finish::sageGlaze), glm::vec3(0.0f), vase, 44);
  const Piece bloom = flower();
  for (int i = 0; i < flowers; ++i) {
    const float angle = kGoldenAngle * static_cast<float>(i);
    const float spread = 0.15f * std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(flowers));
    const glm::vec3 head =
        around(angle) * spread + glm::vec3(0.0f, 0.44f - 0.9f * spread + random.between(-0.03f, 0.03f), 0.0f);
    const std::array<TubePoint, 3> stalk{TubePoint{around(angle) * 0.008f + glm::vec3(0, 0.12f, 0), 0.0018f},
                                         {around(angle) * 0.022f + glm::vec3(0, 0.24f, 0), 0.0018f},
                                         {head, 0.0016f}};
    addTube(piece.part(Finish::stem), stalk, {5, 8});
    piece.add(bloom, at(head, glm::degrees(angle)));
    for (int leaf = 0; leaf < 2; ++leaf) {
      const glm::vec3 foot = alongCurve(stalk, 0.62f + 0.16f * static_cast<float>(leaf)).position;
      const float side = angle + random.between(0.0f, glm::two_pi<float>());
      const Mesh blade = leafMesh({0.022f, 0.06f}, 0.02f, {2, 6});
      modelling::addMesh(piece.part(Finish::leaf), blade, facing(foot, around(side) + glm::vec3(0, 0.5f, 0)));
    }
  }
  return piece;
}

}  // namespace host::furniture
