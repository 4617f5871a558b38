// The end walls: three great windows over the stairs at -z; doors under a rose window at +z. Both are
// modelled in the plane x = 0 with +x towards the nave.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "host/scene/builtin/hall_openings.h"
#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

constexpr float kFoundation = -0.5f;
constexpr float kHalfWall = 0.5f * kThickness;

/// The wall's parts beside the openings, from |z| = `inner` outwards: high by the nave, lower by the aisles.
void addFlanks(Mesh& mesh, float inner, float bottom) {
  for (const auto& [from, to, top] :
       {std::tuple(inner, kAisleFace, kRoof), std::tuple(kAisleFace, kOutside, kGalleryRoof)}) {
    addBox(mesh, {-kHalfWall, bottom, from}, {kHalfWall, top, to});
    addBox(mesh, {-kHalfWall, bottom, -to}, {kHalfWall, top, -from});
  }
}

template <typename Add>
void addShifted(Mesh& mesh, float z, const Add& add) {
  const std::size_t first = mesh.vertices.size();
  add();
  modelling::transformFrom(mesh, first, glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, z}));
}

void addWindowWall(Mesh& mesh) {
  const float sill = kEndWindow.sill;
  constexpr float kMiddleEdge = 1.95f;
  constexpr float kSideHalfWidth = kEndSideWindowOffset - kMiddleEdge;
  addBox(mesh, {-kHalfWall, kFoundation, -kOutside}, {kHalfWall, sill, kOutside});
  addWall(mesh, archedWall(kMiddleEdge, sill, kRoof, kEndWindow.halfWidth, kEndWindow.springing, 24));
  for (const float z : {-kEndSideWindowOffset, kEndSideWindowOffset}) {
    addShifted(mesh, z, [&] {
      addWall(mesh, archedWall(kSideHalfWidth, sill, kRoof, kEndSideWindow.halfWidth,
                               kEndSideWindow.springing, 20));
    });
  }
  addFlanks(mesh, kEndSideWindowOffset + kSideHalfWidth, sill);
}

/// The wall around one half (z >= 0) of the rose.
std::vector<glm::vec2> roseHalf(float halfWidth, float bottom) {
  std::vector<glm::vec2> outline{{0.0f, bottom}, {halfWidth, bottom}, {halfWidth, kRoof}, {0.0f, kRoof}};
  appendArc(outline, {0.0f, kRoseHeight}, kRoseRadius, 90.0f, -90.0f, 24);
  return outline;
}

void addDoorWall(Mesh& mesh) {
  constexpr float kHalfWidth = 3.0f;
  constexpr float kSplit = 6.0f;
  addWall(mesh, archedWall(kHalfWidth, -kSunk, kSplit, kDoor.halfWidth, kDoor.springing, 24));
  const std::vector<glm::vec2> half = roseHalf(kHalfWidth, kSplit);
  addWall(mesh, half);
  const std::size_t first = mesh.vertices.size();
  addWall(mesh, half);
  modelling::transformFrom(mesh, first, glm::rotate(glm::mat4(1.0f), glm::pi<float>(), {0, 1, 0}));
  addFlanks(mesh, kHalfWidth, kFoundation);
}

/// Roll mouldings around an opening with an arch, on the nave's face.
void addSurround(Mesh& mesh, const Opening& opening, float foot) {
  const float radius = opening.halfWidth + 0.06f;
  std::vector<glm::vec3> path{{kHalfWall, foot, -radius}};
  const std::vector<glm::vec3> arch = modelling::arcPath(
      {kHalfWall, opening.springing, 0.0f}, {0, 0, -radius}, {0, radius, 0}, 0.0f, glm::pi<float>(), 24);
  path.insert(path.end(), arch.begin(), arch.end());
  path.emplace_back(kHalfWall, foot, radius);
  std::vector<glm::vec2> section{{0.0f, -0.04f}, {0.3f, -0.04f}, {0.3f, 0.09f}, {0.27f, 0.11f}};
  appendArc(section, {0.2f, 0.08f}, 0.055f, 30.0f, 180.0f, 4);
  section.insert(section.end(), {{0.12f, 0.05f}});
  appendArc(section, {0.06f, 0.05f}, 0.045f, 0.0f, 180.0f, 4);
  section.insert(section.end(), {{0.0f, 0.03f}});
  addSweep(mesh, section, path, false, 40.0f, {1, 0, 0});
}

void addRose(Mesh& mesh) {
  constexpr int kPetals = 12;
  const glm::vec3 hub(0.0f, kRoseHeight, 0.0f);
  const auto ring = [&](glm::vec3 middle, float radius, float thickness) {
    std::vector<glm::vec3> path = modelling::arcPath(middle, {0, 0, -radius}, {0, radius, 0}, 0.0f,
                                                     glm::two_pi<float>(), radius > 1.0f ? 40 : 12);
    path.pop_back();
    addSweep(mesh, modelling::circleOutline(thickness, 5), path, true, 70.0f, {1, 0, 0});
  };
  ring(hub, kRoseRadius - 0.05f, 0.12f);
  ring(hub, 0.5f, 0.07f);
  for (int i = 0; i < kPetals; ++i) {
    const float angle = glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / kPetals;
    const glm::vec3 out(0.0f, std::sin(angle), std::cos(angle));
    const std::vector<glm::vec3> spoke{hub + 0.5f * out, hub + 1.28f * out};
    addSweep(mesh, modelling::circleOutline(0.05f, 6), spoke, false, 70.0f, {1, 0, 0});
    ring(hub + 1.62f * out, 0.36f, 0.05f);
  }
}

/// Two oak leaves with raised panels under the door's arch.
void addDoorLeaves(Mesh& mesh) {
  std::vector<glm::vec2> outline{{-kDoor.halfWidth - 0.05f, kSunk}, {kDoor.halfWidth + 0.05f, kSunk}};
  appendArc(outline, {0.0f, kDoor.springing}, kDoor.halfWidth + 0.05f, 0.0f, 180.0f, 24);
  addWall(mesh, outline, 0.14f);
  for (const float side : {-1.0f, 1.0f}) {
    const float z = side * 0.75f;
    for (const auto& [bottom, top] :
         {std::pair(0.25f, 0.95f), std::pair(1.1f, 2.15f), std::pair(2.3f, 3.3f)}) {
      addBox(mesh, {0.06f, bottom, z - 0.55f}, {0.11f, top, z + 0.55f}, 0.03f);
      addBox(mesh, {0.1f, bottom + 0.14f, z - 0.41f}, {0.14f, top - 0.14f, z + 0.41f}, 0.02f);
    }
  }
  addBox(mesh, {0.06f, 0.02f, -0.05f}, {0.13f, kDoor.crown() - 0.03f, 0.05f}, 0.015f);
}

void addDoorIron(Mesh& mesh) {
  for (const float side : {-1.0f, 1.0f}) {
    for (const float y : {0.62f, 1.02f, 2.22f}) {
      addBox(mesh, {0.065f, y - 0.03f, std::min(side * 1.45f, side * 0.3f)},
             {0.085f, y + 0.03f, std::max(side * 1.45f, side * 0.3f)}, 0.008f);
    }
    std::vector<glm::vec3> ring = modelling::arcPath({0.17f, 1.32f, side * 0.22f}, {0, 0, -0.08f},
                                                     {0, 0.08f, 0}, 0.0f, glm::two_pi<float>(), 16);
    ring.pop_back();
    addSweep(mesh, modelling::circleOutline(0.012f, 6), ring, true, 70.0f, {1, 0, 0});
  }
}

void placeAll(Hall& hall, std::vector<Mesh> meshes, const glm::mat4& transform) {
  for (Mesh& mesh : meshes) hall.builder.place(hall.builder.addMesh(std::move(mesh)), transform);
}

}  // namespace

void addEndWalls(Hall& hall) {
  Mesh windowWall = makeMesh("window wall", hall.material.ashlar);
  addWindowWall(windowWall);
  Mesh dressings = makeMesh("great windows", hall.material.dressed);
  Mesh bars = makeMesh("great windows' bars", hall.material.iron);
  const glm::mat4 deep = glm::translate(glm::mat4(1.0f), {kHalfWall - kReveal, 0.0f, 0.0f});
  for (const auto& [opening, z] :
       {std::pair(kEndWindow, 0.0f), std::pair(kEndSideWindow, kEndSideWindowOffset),
        std::pair(kEndSideWindow, -kEndSideWindowOffset)}) {
    Mesh tracery;
    addTracery(tracery, opening);
    Mesh glazing;
    addGlazingBars(glazing, opening);
    const glm::mat4 shift = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, z});
    modelling::addMesh(dressings, tracery, shift * deep);
    modelling::addMesh(bars, glazing, shift * deep);
    addShifted(dressings, z,
               [&dressings, &opening = opening] { addSurround(dressings, opening, opening.sill); });
  }
  addBox(dressings, {-0.1f, kEndWindow.sill - 0.14f, -4.5f},
         {kHalfWall + 0.16f, kEndWindow.sill + 0.03f, 4.5f}, 0.03f);
  const glm::mat4 identity(1.0f);
  const glm::vec3 farEnd(0.0f, 0.0f, -kHalfLength - kHalfWall);
  placeAll(hall, {std::move(windowWall), std::move(dressings), std::move(bars)},
           glm::rotate(glm::translate(identity, farEnd), -glm::half_pi<float>(), {0, 1, 0}));

  Mesh doorWall = makeMesh("door wall", hall.material.ashlar);
  addDoorWall(doorWall);
  Mesh stone = makeMesh("rose and door surround", hall.material.dressed);
  addRose(stone);
  addSurround(stone, kDoor, -kSunk);
  Mesh leaves = makeMesh("doors", hall.material.oak);
  addDoorLeaves(leaves);
  Mesh iron = makeMesh("door fittings", hall.material.iron);
  addDoorIron(iron);
  placeAll(hall, {std::move(doorWall), std::move(stone), std::move(leaves), std::move(iron)},
           glm::rotate(glm::translate(identity, -farEnd), glm::half_pi<float>(), {0, 1, 0}));
}

}  // namespace host::hall
