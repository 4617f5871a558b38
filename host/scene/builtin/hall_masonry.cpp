// What several parts of the hall share.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {

namespace {
constexpr float kEmbedded = 0.05f;  // how deep a moulding reaches into its wall
}  // namespace

Mesh makeMesh(const char* name, int material) {
  Mesh mesh;
  mesh.name = name;
  mesh.material = material;
  return mesh;
}

void placeOnBothSides(Hall& hall, int mesh, float x, float z, float y) {
  const glm::mat4 identity(1.0f);
  hall.builder.place(mesh, glm::translate(identity, {-x, y, z}));
  hall.builder.place(mesh, glm::rotate(glm::translate(identity, {x, y, z}), glm::pi<float>(), {0, 1, 0}));
}

glm::mat4 onEndWall(float end, float x) {
  const glm::vec3 middle(x, 0.0f, end * (kHalfLength + kHalfWall));
  return glm::rotate(glm::translate(glm::mat4(1.0f), middle), end * glm::half_pi<float>(), {0, 1, 0});
}

void addWall(Mesh& mesh, std::span<const glm::vec2> outline, float thickness) {
  const std::size_t first = mesh.vertices.size();
  modelling::addExtrusion(mesh, outline, thickness);
  const glm::mat4 centred = glm::translate(glm::mat4(1.0f), {-0.5f * thickness, 0.0f, 0.0f});
  modelling::transformFrom(mesh, first, glm::rotate(centred, glm::half_pi<float>(), {0, 1, 0}));
}

std::vector<glm::vec2> archedWall(float halfWidth, float bottom, float top, float openingHalfWidth,
                                  float springing, int segments) {
  std::vector<glm::vec2> outline{{-halfWidth, bottom}, {-openingHalfWidth, bottom}};
  appendArc(outline, {0.0f, springing}, openingHalfWidth, 180.0f, 0.0f, segments);
  outline.insert(outline.end(),
                 {{openingHalfWidth, bottom}, {halfWidth, bottom}, {halfWidth, top}, {-halfWidth, top}});
  return outline;
}

std::vector<glm::vec2> moulding(std::vector<glm::vec2> face) {
  const float bottom = face.front().y;
  const float top = face.back().y;
  face.emplace_back(-kEmbedded, top);
  face.emplace_back(-kEmbedded, bottom);
  return face;
}

void appendArc(std::vector<glm::vec2>& profile, glm::vec2 centre, float radius, float start, float end,
               int segments) {
  for (int i = 0; i <= segments; ++i) {
    const float angle =
        glm::radians(glm::mix(start, end, static_cast<float>(i) / static_cast<float>(segments)));
    profile.push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
  }
}

}  // namespace host::hall
