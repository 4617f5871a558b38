// The outer walls' windows: a stone frame in a deep reveal, two lancets under a round light, iron glazing
// bars.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_openings.h"
#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

constexpr float kFrame = 0.09f;     // half width of the stone bars
constexpr float kMullion = 0.055f;  // of the thinner ones
constexpr int kArchSegments = 16;

/// The cross-section of a bar, chamfered towards the nave (+y).
std::vector<glm::vec2> barSection(float halfWidth) {
  const float halfDepth = 1.3f * halfWidth;
  return {{-halfWidth, -halfDepth},
          {halfWidth, -halfDepth},
          {0.45f * halfWidth, halfDepth},
          {-0.45f * halfWidth, halfDepth}};
}

/// A bar over two jambs and the arch between them, in the plane x = 0.
void addArchedBar(Mesh& mesh, glm::vec2 middle, float bottom, float radius, float halfWidth, int segments) {
  std::vector<glm::vec3> path{{0.0f, bottom, middle.x - radius}};
  const std::vector<glm::vec3> arch = modelling::arcPath({0.0f, middle.y, middle.x}, {0, 0, -radius},
                                                         {0, radius, 0}, 0.0f, glm::pi<float>(), segments);
  path.insert(path.end(), arch.begin(), arch.end());
  path.emplace_back(0.0f, bottom, middle.x + radius);
  addSweep(mesh, barSection(halfWidth), path, false, 50.0f, {1, 0, 0});
}

void addRing(Mesh& mesh, glm::vec2 middle, float radius, float halfWidth) {
  std::vector<glm::vec3> path = modelling::arcPath({0.0f, middle.y, middle.x}, {0, 0, -radius},
                                                   {0, radius, 0}, 0.0f, glm::two_pi<float>(), 14);
  path.pop_back();
  addSweep(mesh, barSection(halfWidth), path, true, 50.0f, {1, 0, 0});
}

}  // namespace

void addTracery(Mesh& mesh, const Opening& opening) {
  const float radius = opening.halfWidth - 0.5f * kFrame;
  addArchedBar(mesh, {0.0f, opening.springing}, opening.sill - kSunk, radius, kFrame, kArchSegments);
  const float lancet = 0.5f * radius;
  const float lancetSpringing = opening.springing - 0.35f * opening.halfWidth;
  for (const float side : {-1.0f, 1.0f}) {
    addArchedBar(mesh, {side * lancet, lancetSpringing}, opening.sill - kSunk, lancet, kMullion, 8);
  }
  addRing(mesh, {0.0f, opening.springing + 0.42f * opening.halfWidth}, 0.34f * opening.halfWidth, kMullion);
}

void addGlazingBars(Mesh& mesh, const Opening& opening) {
  constexpr float kThin = 0.012f;
  const float top = opening.springing - 0.1f;
  const float spacing = 0.62f;
  const int rows = static_cast<int>((top - opening.sill) / spacing);
  const float reach = opening.halfWidth - 0.02f;
  for (int row = 1; row <= rows; ++row) {
    const float y = opening.sill + spacing * static_cast<float>(row);
    addBox(mesh, {-kThin, y - kThin, -reach}, {kThin, y + kThin, reach});
  }
  for (const float side : {-1.0f, 1.0f}) {
    const float z = side * 0.5f * (opening.halfWidth - 0.5f * kFrame);
    addBox(mesh, {-0.8f * kThin, opening.sill - kSunk, z - kThin}, {0.8f * kThin, top + 0.2f, z + kThin});
  }
}

void addWindows(Hall& hall) {
  Mesh stone = makeMesh("window tracery", hall.material.dressed);
  Mesh bars = makeMesh("glazing bars", hall.material.iron);
  for (const Opening& opening : {kAisleWindow, kGalleryWindow}) {
    addTracery(stone, opening);
    addGlazingBars(bars, opening);
  }
  const int stoneIndex = hall.builder.addMesh(std::move(stone));
  const int barsIndex = hall.builder.addMesh(std::move(bars));
  for (const float z : kBayCentres) {
    placeOnBothSides(hall, stoneIndex, kOuterFace + kReveal, z);
    placeOnBothSides(hall, barsIndex, kOuterFace + kReveal, z);
  }
}

}  // namespace host::hall
