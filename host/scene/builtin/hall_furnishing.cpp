// What stands and hangs in the hall: carpets, benches, urns, banners.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

void addCarpets(Hall& hall) {
  constexpr float kFrom = -8.6f;
  constexpr float kTo = 15.6f;
  Mesh field = makeMesh("carpet", hall.material.carpet);
  addBox(field, {-1.3f, -kSunk, kFrom}, {1.3f, 0.014f, kTo}, 0.004f);
  Mesh border = makeMesh("carpet border", hall.material.carpetBorder);
  for (const float x : {-1.12f, 1.12f})
    addBox(border, {x - 0.07f, 0.0f, kFrom + 0.1f}, {x + 0.07f, 0.019f, kTo - 0.1f});
  for (const float z : {kFrom + 0.17f, kTo - 0.17f}) {
    addBox(border, {-1.05f, 0.0f, z - 0.07f}, {1.05f, 0.019f, z + 0.07f});
  }
  hall.builder.place(hall.builder.addMesh(std::move(field)));
  hall.builder.place(hall.builder.addMesh(std::move(border)));
}

/// An oak bench along z with its back to -x.
void addBench(Mesh& mesh) {
  constexpr float kHalf = 1.1f;
  const std::vector<glm::vec2> side{{-0.24f, -kSunk}, {-0.1f, -kSunk}, {-0.04f, 0.12f}, {0.08f, 0.12f},
                                    {0.14f, -kSunk},  {0.26f, -kSunk}, {0.24f, 0.42f},  {0.26f, 0.6f},
                                    {0.2f, 0.66f},    {-0.14f, 0.62f}, {-0.2f, 1.0f},   {-0.28f, 1.06f},
                                    {-0.3f, 0.98f},   {-0.26f, 0.5f}};
  for (const float z : {-kHalf, 0.0f, kHalf}) {
    const std::size_t first = mesh.vertices.size();
    modelling::addExtrusion(mesh, side, 0.07f, 25.0f);
    modelling::transformFrom(mesh, first, glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, z - 0.035f}));
  }
  for (int slat = 0; slat < 4; ++slat) {
    const float x = -0.17f + 0.115f * static_cast<float>(slat);
    addBox(mesh, {x, 0.4f, -kHalf - 0.06f}, {x + 0.1f, 0.44f, kHalf + 0.06f});
  }
  for (int slat = 0; slat < 3; ++slat) {
    const float y = 0.56f + 0.16f * static_cast<float>(slat);
    const float x = -0.215f - 0.018f * static_cast<float>(slat);
    addBox(mesh, {x - 0.03f, y, -kHalf - 0.04f}, {x, y + 0.11f, kHalf + 0.04f});
  }
}

void addBenches(Hall& hall) {
  Mesh mesh = makeMesh("bench", hall.material.oak);
  addBench(mesh);
  const int bench = hall.builder.addMesh(std::move(mesh));
  for (const float z : {-10.0f, -5.0f, 0.0f, 5.0f, 10.0f})
    placeOnBothSides(hall, bench, kOuterFace - 0.46f, z);
}

/// Urns on red marble pedestals beside the doors and in the outermost bays.
void addUrns(Hall& hall) {
  Mesh pedestal = makeMesh("urn pedestal", hall.material.redMarble);
  addBox(pedestal, {-0.3f, -kSunk, -0.3f}, {0.3f, 0.14f, 0.3f}, 0.02f);
  addBox(pedestal, {-0.24f, 0.13f, -0.24f}, {0.24f, 0.82f, 0.24f}, 0.02f);
  addBox(pedestal, {-0.3f, 0.81f, -0.3f}, {0.3f, 0.92f, 0.3f}, 0.03f);
  Mesh urn = makeMesh("urn", hall.material.paleMarble);
  addUrn(urn, {0.0f, 0.92f, 0.0f}, 0.95f);
  const int pedestalIndex = hall.builder.addMesh(std::move(pedestal));
  const int urnIndex = hall.builder.addMesh(std::move(urn));
  for (const float z : {16.7f, -11.2f}) {
    for (const int part : {pedestalIndex, urnIndex}) placeOnBothSides(hall, part, z > 0.0f ? 3.1f : 4.6f, z);
  }
}

/// Cloth that hangs from y = 0 down to a pointed end, rippled, facing +x.
void addBannerCloth(Mesh& mesh) {
  constexpr float kHalfWidth = 0.6f;
  constexpr float kLength = 2.9f;
  const auto cloth = [](float u, float v) {
    const float across = 2.0f * u - 1.0f;
    const float down = 1.0f - v;
    const float length = kLength - 0.45f * std::abs(across);
    const float ripple =
        0.05f * down * std::sin(7.0f * across + 1.5f * down) + 0.03f * down * std::sin(4.0f * down);
    return glm::vec3(ripple, -length * down, -kHalfWidth * across);
  };
  modelling::addPatch(mesh, cloth, {10, 12});
}

/// Banners on poles: beside the doors, and along the nave on the piers between the gallery's arches.
void addBanners(Hall& hall) {
  Mesh cloth = makeMesh("banner", hall.material.banner);
  addBannerCloth(cloth);
  Mesh pole = makeMesh("banner pole", hall.material.bronze);
  const std::vector<glm::vec3> bar{{0.0f, 0.02f, 1.0f}, {0.0f, 0.02f, -0.72f}};
  addSweep(pole, modelling::circleOutline(0.025f, 8), bar);
  modelling::addEllipsoid(pole, {0.0f, 0.02f, -0.74f}, glm::vec3(0.045f), {8, 6});
  const int clothIndex = hall.builder.addMesh(std::move(cloth));
  const int poleIndex = hall.builder.addMesh(std::move(pole));
  constexpr float kHeight = 9.3f;
  constexpr float kReach = 1.12f;  // from the wall to the banner's middle
  for (const float z : {-7.5f, 2.5f, 12.5f}) {
    for (const float side : {-1.0f, 1.0f}) {  // the pole's free end (-z) turns to the middle of the nave
      const glm::vec3 place(side * (kNaveFace - kReach), kHeight, z);
      const glm::mat4 placed =
          glm::rotate(glm::translate(glm::mat4(1.0f), place), side * glm::half_pi<float>(), {0, 1, 0});
      hall.builder.place(clothIndex, placed);
      hall.builder.place(poleIndex, placed);
    }
  }
}

}  // namespace

void addUrn(Mesh& mesh, glm::vec3 base, float height) {
  const std::vector<glm::vec2> unit{
      {0.0f, -0.02f}, {0.17f, -0.02f}, {0.17f, 0.03f}, {0.11f, 0.06f}, {0.05f, 0.12f}, {0.06f, 0.17f},
      {0.09f, 0.19f}, {0.06f, 0.22f},  {0.16f, 0.28f}, {0.27f, 0.4f},  {0.31f, 0.53f}, {0.29f, 0.64f},
      {0.2f, 0.72f},  {0.17f, 0.77f},  {0.19f, 0.83f}, {0.28f, 0.88f}, {0.28f, 0.91f}, {0.22f, 0.925f},
      {0.1f, 0.95f},  {0.05f, 0.97f},  {0.06f, 1.0f},  {0.0f, 1.02f}};
  std::vector<glm::vec2> profile;
  profile.reserve(unit.size());
  for (const glm::vec2 point : unit) profile.push_back(height * point);
  modelling::addLathe(mesh, base, profile, 12, 50.0f);
}

void addFurnishing(Hall& hall) {
  addCarpets(hall);
  addBenches(hall);
  addUrns(hall);
  addBanners(hall);
}

}  // namespace host::hall
