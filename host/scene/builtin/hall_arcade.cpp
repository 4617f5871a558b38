// The two walls between nave and aisles: arches on the columns below, the gallery's arches above, and their
// mouldings.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

constexpr int kArchSegments = 18;
constexpr float kCorniceBottom = kGallery - 0.47f;

/// The moulded band around an arch, `facing` +1 on the nave's side of the wall and -1 on the other.
void addArchivolt(Mesh& mesh, float springing, float facing) {
  // (away from the arch, out of the wall): rich towards the nave, plain towards the aisle
  const std::vector<glm::vec2> rich{{0.03f, -0.03f}, {0.34f, -0.03f}, {0.34f, 0.115f}, {0.28f, 0.1f},
                                    {0.22f, 0.06f},  {0.13f, 0.05f},  {0.12f, 0.03f},  {0.03f, 0.03f}};
  const std::vector<glm::vec2> plain{{0.03f, -0.03f}, {0.34f, -0.03f}, {0.3f, 0.08f}, {0.03f, 0.035f}};
  const std::vector<glm::vec2>& section = facing > 0.0f ? rich : plain;
  const glm::vec3 along(0.0f, 0.0f, facing);  // this way round, a sweep's right is away from the arch
  const std::vector<glm::vec3> path =
      modelling::arcPath({facing * kHalfWall, springing, 0.0f}, -kArchRadius * along,
                         {0.0f, kArchRadius, 0.0f}, 0.0f, glm::pi<float>(), kArchSegments);
  addSweep(mesh, section, path, false, 40.0f, {facing, 0.0f, 0.0f});
}

/// A wedge that closes the arch at its crown.
void addKeystone(Mesh& mesh, float springing, float facing) {
  const float crown = springing + kArchRadius;
  const std::vector<glm::vec2> wedge{
      {-0.11f, crown - 0.06f}, {0.11f, crown - 0.06f}, {0.19f, crown + 0.41f}, {-0.19f, crown + 0.41f}};
  const std::size_t first = mesh.vertices.size();
  addWall(mesh, wedge, 0.2f);
  modelling::transformFrom(mesh, first,
                           glm::translate(glm::mat4(1.0f), {facing * (kHalfWall + 0.06f), 0.0f, 0.0f}));
}

void addArchMouldings(Mesh& mesh) {
  for (const float facing : {1.0f, -1.0f}) {
    addArchivolt(mesh, kSpringing, facing);
    addKeystone(mesh, kUpperSpringing, facing);
  }
  addArchivolt(mesh, kUpperSpringing, 1.0f);
  addKeystone(mesh, kSpringing, 1.0f);
}

/// The imposts from which the gallery's arches spring.
void addImposts(Mesh& mesh) {
  for (const float side : {-1.0f, 1.0f}) {
    const float end = side * 0.5f * kBay;
    const float edge = side * (kArchRadius - 0.06f);
    addBox(mesh, {-0.6f, kUpperSpringing - 0.2f, std::min(end, edge)},
           {0.6f, kUpperSpringing, std::max(end, edge)});
  }
}

/// A flat pilaster on the gallery's piers that carries the nave vault's ribs, centred on z = 0.
void addPilaster(Mesh& mesh) {
  const float face = kHalfWall;
  const auto block = [&](float bottom, float top, float halfWidth, float projection, float bevel) {
    addBox(mesh, {face - 0.04f, bottom, -halfWidth}, {face + projection, top, halfWidth}, bevel);
  };
  block(kGallery + 0.1f, kGallery + 0.42f, 0.36f, 0.24f, 0.0f);
  block(kGallery + 0.4f, kVaultSpringing - 0.42f, 0.29f, 0.18f, 0.02f);
  block(kVaultSpringing - 0.43f, kVaultSpringing - 0.36f, 0.32f, 0.21f, 0.0f);
  block(kVaultSpringing - 0.3f, kVaultSpringing - 0.16f, 0.33f, 0.24f, 0.03f);
  block(kVaultSpringing - 0.18f, kVaultSpringing + 0.02f, 0.4f, 0.33f, 0.02f);
  block(kVaultSpringing - 0.37f, kVaultSpringing - 0.29f, 0.285f, 0.17f, 0.0f);
}

/// The nave's main cornice, below the gallery's floor.
void addCornice(Mesh& mesh) {
  std::vector<glm::vec2> face{{0.04f, kCorniceBottom}, {0.04f, kCorniceBottom + 0.08f}};
  appendArc(face, {0.04f, kCorniceBottom + 0.14f}, 0.05f, -80.0f, 80.0f, 4);
  face.insert(face.end(), {{0.06f, kCorniceBottom + 0.2f},
                           {0.06f, kCorniceBottom + 0.33f},
                           {0.16f, kCorniceBottom + 0.335f},
                           {0.2f, kCorniceBottom + 0.36f},
                           {0.27f, kCorniceBottom + 0.375f},
                           {0.27f, kCorniceBottom + 0.45f},
                           {0.28f, kCorniceBottom + 0.49f}});
  appendArc(face, {0.29f, kCorniceBottom + 0.53f}, 0.04f, -60.0f, 60.0f, 3);
  face.emplace_back(0.3f, kGallery + 0.11f);
  face.emplace_back(-0.02f, kGallery + 0.13f);
  const float x = kHalfWall;
  const std::vector<glm::vec3> path{{x, 0.0f, kHalfLength}, {x, 0.0f, -kHalfLength}};
  addSweep(mesh, moulding(std::move(face)), path);
}

void addDentils(Mesh& mesh) {
  constexpr int kDentils = 18;  // a bay
  const float x = kHalfWall;
  for (int i = 0; i < kDentils; ++i) {
    const float z = (static_cast<float>(i) + 0.5f) * kBay / kDentils - 0.5f * kBay;
    addBox(mesh, {x + 0.04f, kCorniceBottom + 0.22f, z - 0.07f},
           {x + 0.15f, kCorniceBottom + 0.34f, z + 0.07f});
  }
}

/// A round boss in each spandrel over the columns, centred on z = 0.
void addRoundel(Mesh& mesh) {
  std::vector<glm::vec2> profile{{0.3f, -0.03f}};
  appendArc(profile, {0.27f, 0.02f}, 0.04f, -20.0f, 160.0f, 4);
  profile.insert(profile.end(), {{0.2f, 0.015f}, {0.12f, 0.02f}, {0.08f, 0.06f}, {0.0f, 0.075f}});
  const std::size_t first = mesh.vertices.size();
  modelling::addLathe(mesh, {0, 0, 0}, profile, 14);
  const glm::mat4 onWall = glm::translate(glm::mat4(1.0f), {kHalfWall, 5.62f, 0.0f});
  modelling::transformFrom(mesh, first, glm::rotate(onWall, -glm::half_pi<float>(), {0, 0, 1}));
}

}  // namespace

void addArcades(Hall& hall) {
  Mesh wall = makeMesh("arcade wall", hall.material.ashlar);
  addWall(wall,
          archedWall(0.5f * kBay, kSpringing - kSunk, kGallery, kArchRadius, kSpringing, kArchSegments));
  addWall(wall, archedWall(0.5f * kBay, kGallery, kRoof, kArchRadius, kUpperSpringing, kArchSegments));
  Mesh mouldings = makeMesh("arch mouldings", hall.material.dressed);
  addArchMouldings(mouldings);
  addImposts(mouldings);
  addDentils(mouldings);
  Mesh piers = makeMesh("pilaster and roundel", hall.material.dressed);
  addPilaster(piers);
  addRoundel(piers);
  Mesh cornice = makeMesh("nave cornice", hall.material.dressed);
  addCornice(cornice);

  const int wallIndex = hall.builder.addMesh(std::move(wall));
  const int mouldingsIndex = hall.builder.addMesh(std::move(mouldings));
  const int piersIndex = hall.builder.addMesh(std::move(piers));
  for (const float z : kBayCentres) {
    placeOnBothSides(hall, wallIndex, kArcade, z);
    placeOnBothSides(hall, mouldingsIndex, kArcade, z);
  }
  for (const float z : kColumnLines) placeOnBothSides(hall, piersIndex, kArcade, z);
  placeOnBothSides(hall, hall.builder.addMesh(std::move(cornice)), kArcade, 0.0f);
}

}  // namespace host::hall
