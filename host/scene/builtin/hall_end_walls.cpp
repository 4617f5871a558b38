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

/// Tracery, glazing bars and surround of one great window, its middle at `z`.
void addGreatWindow(Mesh& dressings, Mesh& bars, const Opening& opening, float z) {
  Mesh tracery;
  addTracery(tracery, opening);
  Mesh glazing;
  addGlazingBars(glazing, opening);
  const glm::mat4 deep = glm::translate(glm::mat4(1.0f), {kHalfWall - kReveal, 0.0f, z});
  modelling::addMesh(dressings, tracery, deep);
  modelling::addMesh(bars, glazing, deep);
  addShifted(dressings, z, [&] { addSurround(dressings, opening, opening.sill); });
}

void addFarEnd(Hall& hall) {
  Mesh wall = makeMesh("window wall", hall.material.ashlar);
  addWindowWall(wall);
  Mesh dressings = makeMesh("great windows", hall.material.dressed);
  Mesh bars = makeMesh("great windows' bars", hall.material.iron);
  addGreatWindow(dressings, bars, kEndWindow, 0.0f);
  addGreatWindow(dressings, bars, kEndSideWindow, kEndSideWindowOffset);
  addGreatWindow(dressings, bars, kEndSideWindow, -kEndSideWindowOffset);
  addBox(dressings, {-0.1f, kEndWindow.sill - 0.14f, -4.5f},
         {kHalfWall + 0.16f, kEndWindow.sill + 0.03f, 4.5f}, 0.03f);
  for (Mesh* mesh : {&wall, &dressings, &bars}) {
    hall.builder.place(hall.builder.addMesh(std::move(*mesh)), onEndWall(-1.0f, 0.0f));
  }
}

void addNearEnd(Hall& hall) {
  Mesh wall = makeMesh("door wall", hall.material.ashlar);
  addDoorWall(wall);
  Mesh rose = makeMesh("rose", hall.material.dressed);
  addRose(rose);
  for (Mesh* mesh : {&wall, &rose}) {
    hall.builder.place(hall.builder.addMesh(std::move(*mesh)), onEndWall(1.0f, 0.0f));
  }
}

}  // namespace

void addEndWalls(Hall& hall) {
  addFarEnd(hall);
  addNearEnd(hall);
}

}  // namespace host::hall
