#include "host/scene/builtin/furniture.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace host::furniture {

float Random::between(float low, float high) {
  constexpr float kScale = 1.0f / 16777216.0f;  // 2^-24: every value is exact in a float
  return low + (high - low) * static_cast<float>(engine_() >> 8) * kScale;
}

int Random::index(int count) {
  return static_cast<int>(engine_() % static_cast<std::uint32_t>(count));
}

void Piece::add(const Piece& other, const glm::mat4& transform) {
  for (const auto& [finish, mesh] : other.parts_) modelling::addMesh(parts_[finish], mesh, transform);
}

Interior::Handle Interior::add(const Piece& piece) {
  Handle handle;
  for (const auto& [finish, part] : piece.parts()) {
    Mesh mesh = part;
    mesh.material = materialOf(finish);
    mesh.name = fmt::format("{}.{}", piece.name(), builder_.scene().materials[mesh.material].name);
    handle.push_back(builder_.addMesh(std::move(mesh)));
  }
  return handle;
}

void Interior::place(const Handle& handle, const glm::mat4& transform) {
  for (const int mesh : handle) builder_.place(mesh, transform);
}

int Interior::materialOf(Finish finish) {
  const auto [entry, isNew] = materials_.try_emplace(finish, -1);
  if (isNew) entry->second = addFinish(builder_, finish);
  return entry->second;
}

glm::mat4 at(glm::vec3 position, float yawDegrees, float scale) {
  const glm::mat4 moved = glm::translate(glm::mat4(1.0f), position);
  return glm::scale(moved * turned(yawDegrees, {0.0f, 1.0f, 0.0f}), glm::vec3(scale));
}

glm::mat4 turned(float degrees, glm::vec3 axis) {
  return glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis);
}

}  // namespace host::furniture
