#include <algorithm>
#include <array>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addBox;
using modelling::addSweep;

constexpr float kPlinth = 0.13f;      // height of the lower rail
constexpr float kRailMiddle = 0.93f;  // height of the handrail's middle
constexpr int kAcrossOpening = 10;
constexpr int kSegments = 8;  // seen from farther than those of the stairs

std::vector<glm::vec2> handrailSection() {
  return {{-0.1f, -0.06f}, {0.1f, -0.06f},   {0.11f, -0.03f}, {0.135f, 0.0f},
          {0.14f, 0.035f}, {0.12f, 0.06f},   {0.06f, 0.075f}, {-0.06f, 0.075f},
          {-0.12f, 0.06f}, {-0.14f, 0.035f}, {-0.135f, 0.0f}, {-0.11f, -0.03f}};
}

}  // namespace

void addBaluster(Mesh& mesh, int segments) {
  addBox(mesh, {-0.07f, -kSunk, -0.07f}, {0.07f, 0.07f, 0.07f});
  addBox(mesh, {-0.065f, kBalusterHeight - 0.06f, -0.065f}, {0.065f, kBalusterHeight + kSunk, 0.065f});
  constexpr std::array<glm::vec2, 11> kTurned{{{0.07f, 0.065f},
                                               {0.068f, 0.1f},
                                               {0.045f, 0.12f},
                                               {0.068f, 0.175f},
                                               {0.088f, 0.24f},
                                               {0.07f, 0.335f},
                                               {0.038f, 0.47f},
                                               {0.038f, 0.575f},
                                               {0.06f, 0.605f},
                                               {0.044f, 0.64f},
                                               {0.066f, 0.715f}}};
  modelling::addLathe(mesh, {0, 0, 0}, kTurned, segments, 60.0f);
}

void addBalustradeRun(Mesh& mesh, glm::vec3 from, glm::vec3 to, int count, int segments) {
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  const std::vector<glm::vec3> rail{from + kRailMiddle * up, to + kRailMiddle * up};
  addSweep(mesh, handrailSection(), rail, false, 30.0f);
  const std::vector<glm::vec3> plinth{from + 0.5f * (kPlinth - kSunk) * up,
                                      to + 0.5f * (kPlinth - kSunk) * up};
  addSweep(mesh, modelling::rectangleOutline(0.22f, kPlinth + kSunk), plinth);
  Mesh baluster;
  addBaluster(baluster, segments);
  for (int i = 0; i < count; ++i) {
    const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const glm::vec3 foot = glm::mix(from, to, t) + kPlinth * up;
    modelling::addMesh(mesh, baluster, glm::translate(glm::mat4(1.0f), foot));
  }
}

void addBalustrades(Hall& hall) {
  Mesh mesh = makeMesh("gallery balustrade", hall.material.paleMarble);
  const float end = kArchRadius + kSunk;
  const float x = 0.2f;  // towards the nave
  addBalustradeRun(mesh, {x, kGallery, end}, {x, kGallery, -end}, kAcrossOpening, kSegments);
  const int index = hall.builder.addMesh(std::move(mesh));
  for (const float z : kBayCentres) placeOnBothSides(hall, index, kArcade, z);
}

}  // namespace host::hall
