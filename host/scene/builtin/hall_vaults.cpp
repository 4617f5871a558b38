// Groin vaults: over each bay two barrels meet, and the higher of both is the ceiling. Their groins carry
// ribs.
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addPatch;
using modelling::addSweep;

/// A bay's vault over |x| <= span.x and |z| <= span.y, both barrels half ellipses of one rise above y = 0.
struct GroinVault {
  glm::vec2 span;
  float rise;

  /// On one of the two webs that follow the barrel along z: `across` -1..1 from groin to groin, `out` 0..1
  /// from the crown to the edge at +z (`side` +1) or -z.
  [[nodiscard]] glm::vec3 alongNave(float across, float out, float side) const {
    const float groin = out * glm::half_pi<float>();
    return {span.x * std::sin(across * groin), rise * std::cos(across * groin),
            side * span.y * std::sin(groin)};
  }
  /// The same for the barrel along x.
  [[nodiscard]] glm::vec3 acrossNave(float across, float out, float side) const {
    const float groin = out * glm::half_pi<float>();
    return {side * span.x * std::sin(groin), rise * std::cos(across * groin),
            span.y * std::sin(across * groin)};
  }
};

void addWebs(Mesh& mesh, const GroinVault& vault, glm::ivec2 segments) {
  for (const float side : {1.0f, -1.0f}) {  // u runs so that the webs face down
    addPatch(
        mesh, [&](float u, float v) { return vault.alongNave(side * (2.0f * u - 1.0f), v, side); }, segments);
    addPatch(
        mesh, [&](float u, float v) { return vault.acrossNave(side * (1.0f - 2.0f * u), v, side); },
        segments);
  }
}

/// A rib's cross-section below a vault (y = 0 is the vault's surface, -y hangs into the room).
std::vector<glm::vec2> ribSection(float halfWidth, float depth) {
  return {{-halfWidth, 0.06f},        {-halfWidth, -0.4f * depth}, {-0.4f * halfWidth, -depth},
          {0.4f * halfWidth, -depth}, {halfWidth, -0.4f * depth},  {halfWidth, 0.06f}};
}

/// A rib over the half ellipse from -foot to +foot.
void addRib(Mesh& mesh, glm::vec3 foot, float rise, glm::vec2 section, int segments) {
  const std::vector<glm::vec3> path =
      modelling::arcPath({0, 0, 0}, -foot, {0.0f, rise, 0.0f}, 0.0f, glm::pi<float>(), segments);
  addSweep(mesh, ribSection(section.x, section.y), path, false, 40.0f, -foot);
}

/// A turned boss that hangs where the ribs cross.
void addBoss(Mesh& mesh, float y, float radius) {
  const std::vector<glm::vec2> profile{{0.0f, -0.34f},  {0.07f, -0.33f}, {0.1f, -0.27f},
                                       {0.06f, -0.22f}, {0.18f, -0.19f}, {0.24f, -0.12f},
                                       {0.2f, -0.06f},  {0.3f, -0.02f},  {0.3f, 0.04f}};
  std::vector<glm::vec2> scaled;
  scaled.reserve(profile.size());
  for (const glm::vec2 point : profile) scaled.push_back(point * (radius / 0.3f));
  modelling::addLathe(mesh, {0, y, 0}, scaled, 16);
}

void addNaveVault(Hall& hall) {
  const GroinVault vault{{kNaveFace + 0.07f, 0.5f * kBay}, kVaultRise};
  Mesh webs = makeMesh("nave vault", hall.material.vault);
  addWebs(webs, vault, {14, 8});
  Mesh diagonals = makeMesh("nave vault ribs", hall.material.dressed);
  addRib(diagonals, {vault.span.x, 0.0f, vault.span.y}, vault.rise, {0.11f, 0.2f}, 22);
  addRib(diagonals, {vault.span.x, 0.0f, -vault.span.y}, vault.rise, {0.11f, 0.2f}, 22);
  Mesh boss = makeMesh("nave vault boss", hall.material.bronze);
  addBoss(boss, vault.rise, 0.42f);
  Mesh transverse = makeMesh("nave transverse rib", hall.material.dressed);
  addRib(transverse, {vault.span.x, 0.0f, 0.0f}, vault.rise, {0.24f, 0.3f}, 26);

  const int websIndex = hall.builder.addMesh(std::move(webs));
  const int diagonalsIndex = hall.builder.addMesh(std::move(diagonals));
  const int bossIndex = hall.builder.addMesh(std::move(boss));
  const int transverseIndex = hall.builder.addMesh(std::move(transverse));
  const glm::mat4 identity(1.0f);
  for (const float z : kBayCentres) {
    for (const int part : {websIndex, diagonalsIndex, bossIndex}) {
      hall.builder.place(part, glm::translate(identity, {0, kVaultSpringing, z}));
    }
  }
  for (const float z : kColumnLines) {
    hall.builder.place(transverseIndex, glm::translate(identity, {0, kVaultSpringing, z}));
  }
}

void addAisleVaults(Hall& hall) {
  const GroinVault vault{{0.5f * (kOuterFace - kAisleFace) + 0.04f, 0.5f * kBay}, kAisleVaultRise};
  const float middle = 0.5f * (kOuterFace + kAisleFace);
  Mesh webs = makeMesh("aisle vault", hall.material.vault);
  addWebs(webs, vault, {8, 5});
  Mesh ribs = makeMesh("aisle transverse rib", hall.material.dressed);
  addRib(ribs, {vault.span.x, 0.0f, 0.0f}, vault.rise, {0.22f, 0.24f}, 16);
  const int websIndex = hall.builder.addMesh(std::move(webs));
  const int ribsIndex = hall.builder.addMesh(std::move(ribs));
  for (const float z : kBayCentres) placeOnBothSides(hall, websIndex, middle, z, kSpringing);
  for (const float z : kColumnLines) placeOnBothSides(hall, ribsIndex, middle, z, kSpringing);
}

}  // namespace

void addVaults(Hall& hall) {
  addNaveVault(hall);
  addAisleVaults(hall);
}

}  // namespace host::hall
