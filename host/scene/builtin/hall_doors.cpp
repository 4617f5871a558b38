// The great doors below the rose, and a small door at each end of both aisles, modelled in the plane x = 0
// with +x towards the hall's inside.
#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "host/scene/builtin/hall_openings.h"
#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

constexpr Opening kSideDoor{0.0f, 2.1f, 0.75f};

/// Two oak leaves with raised panels under the door's arch.
void addDoorLeaves(Mesh& mesh) {
  std::vector<glm::vec2> outline{{-kDoor.halfWidth - 0.05f, -kSunk}, {kDoor.halfWidth + 0.05f, -kSunk}};
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

/// A narrow door that lies on the wall's face, with raised panels.
void addSideDoorLeaf(Mesh& mesh) {
  std::vector<glm::vec2> outline{{-kSideDoor.halfWidth - 0.1f, -kSunk}, {kSideDoor.halfWidth + 0.1f, -kSunk}};
  appendArc(outline, {0.0f, kSideDoor.springing}, kSideDoor.halfWidth + 0.1f, 0.0f, 180.0f, 14);
  const std::size_t first = mesh.vertices.size();
  addWall(mesh, outline, 0.08f);
  modelling::transformFrom(mesh, first, glm::translate(glm::mat4(1.0f), {kHalfWall, 0.0f, 0.0f}));
  for (const float z : {-0.36f, 0.36f}) {
    for (const auto& [bottom, top] : {std::pair(0.2f, 0.95f), std::pair(1.1f, 2.0f)}) {
      addBox(mesh, {kHalfWall + 0.02f, bottom, z - 0.28f}, {kHalfWall + 0.065f, top, z + 0.28f}, 0.02f);
    }
  }
}

void addSideDoors(Hall& hall) {
  Mesh leaf = makeMesh("side door", hall.material.oak);
  addSideDoorLeaf(leaf);
  Mesh frame = makeMesh("side door surround", hall.material.dressed);
  addSurround(frame, kSideDoor, -kSunk);
  const int leafIndex = hall.builder.addMesh(std::move(leaf));
  const int frameIndex = hall.builder.addMesh(std::move(frame));
  constexpr float kAisleMiddle = 0.5f * (kAisleFace + kOuterFace);
  for (const float end : {-1.0f, 1.0f}) {
    for (const float x : {-kAisleMiddle, kAisleMiddle}) {
      hall.builder.place(leafIndex, onEndWall(end, x));
      hall.builder.place(frameIndex, onEndWall(end, x));
    }
  }
}

}  // namespace

/// Roll mouldings around an opening with an arch, on the nave's face.
void addSurround(Mesh& mesh, const Opening& opening, float foot) {
  const float radius = opening.halfWidth + 0.06f;
  std::vector<glm::vec3> path{{kHalfWall, foot, -radius}};
  const std::vector<glm::vec3> arch = modelling::arcPath(
      {kHalfWall, opening.springing, 0.0f}, {0, 0, -radius}, {0, radius, 0}, 0.0f, glm::pi<float>(), 20);
  path.insert(path.end(), arch.begin(), arch.end());
  path.emplace_back(kHalfWall, foot, radius);
  std::vector<glm::vec2> section{{0.0f, -0.04f}, {0.3f, -0.04f}, {0.3f, 0.09f}, {0.27f, 0.11f}};
  appendArc(section, {0.2f, 0.08f}, 0.055f, 30.0f, 180.0f, 3);
  section.insert(section.end(), {{0.12f, 0.05f}});
  appendArc(section, {0.06f, 0.05f}, 0.045f, 0.0f, 180.0f, 3);
  section.insert(section.end(), {{0.0f, 0.03f}});
  addSweep(mesh, section, path, false, 40.0f, {1, 0, 0});
}

void addDoors(Hall& hall) {
  Mesh leaves = makeMesh("doors", hall.material.oak);
  addDoorLeaves(leaves);
  Mesh iron = makeMesh("door fittings", hall.material.iron);
  addDoorIron(iron);
  Mesh frame = makeMesh("door surround", hall.material.dressed);
  addSurround(frame, kDoor, -kSunk);
  for (Mesh* mesh : {&leaves, &iron, &frame}) {
    hall.builder.place(hall.builder.addMesh(std::move(*mesh)), onEndWall(1.0f, 0.0f));
  }
  addSideDoors(hall);
}

}  // namespace host::hall
