// What the furnished scenes (`office`, `breakfast`) are put together from: a Piece is one object in its own
// coordinates (+Y up, front towards +Z, resting on y = 0), an Interior is the scene that pieces are placed
// in.
#pragma once

#include <map>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "host/scene/builtin/furniture_finishes.h"
#include "host/scene/builtin/modelling.h"

namespace host::furniture {

/// Numbers that are the same on every platform, unlike those of the standard distributions.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  float between(float low, float high);
  int index(int count);  ///< 0 .. count - 1

 private:
  std::mt19937 engine_;
};

/// One object: a mesh per finish.
class Piece {
 public:
  explicit Piece(std::string name) : name_(std::move(name)) {}

  /// The mesh of this finish, empty at first. The reference stays valid.
  Mesh& part(Finish finish) { return parts_[finish]; }

  /// Merges a copy of `other`.
  void add(const Piece& other, const glm::mat4& transform);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::map<Finish, Mesh>& parts() const { return parts_; }

 private:
  std::string name_;
  std::map<Finish, Mesh> parts_;
};

/// A scene of pieces. Finishes become materials when they are first used.
class Interior {
 public:
  /// The meshes of a piece that was added.
  using Handle = std::vector<int>;

  explicit Interior(std::string name) : builder_(std::move(name)) {}

  Handle add(const Piece& piece);
  void place(const Handle& handle, const glm::mat4& transform);
  void place(const Piece& piece, const glm::mat4& transform = glm::mat4(1.0f)) {
    place(add(piece), transform);
  }

  Scene& scene() { return builder_.scene(); }
  Scene take() { return builder_.take(); }

 private:
  int materialOf(Finish finish);

  modelling::SceneBuilder builder_;
  std::map<Finish, int> materials_;
};

/// Placement: scaled, then turned about +Y by `yawDegrees`, then moved.
glm::mat4 at(glm::vec3 position, float yawDegrees = 0.0f, float scale = 1.0f);

/// Turned about `axis` by `degrees`.
glm::mat4 turned(float degrees, glm::vec3 axis);

}  // namespace host::furniture
