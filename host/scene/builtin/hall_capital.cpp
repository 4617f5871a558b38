// A capital after the Corinthian order: bell, two rows of leaves, volutes under the corners of a hollow-sided
// abacus.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/hall_parts.h"

namespace host::hall {
namespace {

using modelling::addExtrusion;
using modelling::addLathe;
using modelling::addMesh;
using modelling::addPatch;
using modelling::addSweep;

constexpr float kAbacusBottom = 0.64f;
constexpr int kLeavesInARow = 8;

float bellRadius(float y) {
  const float t = y / kAbacusBottom;
  return kShaftTopRadius - 0.02f + 0.14f * t * t * t;
}

void addBell(Mesh& mesh) {
  std::vector<glm::vec2> profile;
  for (int i = 0; i <= 4; ++i) {
    const float y = kAbacusBottom * static_cast<float>(i) / 4.0f;
    profile.emplace_back(bellRadius(y), y);
  }
  profile.emplace_back(0.0f, kAbacusBottom + 0.01f);
  addLathe(mesh, {0, 0, 0}, profile, 16);
}

/// One acanthus leaf, growing along +y in front of the bell at +z and curling outwards at the tip.
struct Leaf {
  float height;
  float halfWidth;
  float curl;    ///< how far the tip leans out
  float bottom;  ///< where it leaves the bell

  /// The midrib: (distance from the axis, height).
  [[nodiscard]] glm::vec2 midrib(float along) const {
    constexpr float kTop = 0.8f;  // where the tip begins to droop
    const float rise = std::sin(along / kTop * glm::half_pi<float>());
    const float y = bottom + height * rise;
    return {bellRadius(std::min(y, bottom + height)) + curl * std::pow(along, 3.0f) + 0.02f, y};
  }

  /// `behind` metres behind the leaf's front, 0 at its border.
  [[nodiscard]] glm::vec3 at(float across, float along, float behind) const {
    constexpr float kStep = 0.01f;
    const glm::vec2 growth = glm::normalize(midrib(along + kStep) - midrib(along - kStep));
    const glm::vec2 front(growth.y, -growth.x);
    // Broad below, pointed above.
    const float outline = std::pow(std::sin(glm::pi<float>() * glm::mix(0.26f, 0.98f, along)), 0.9f);
    const float x = across * halfWidth * outline;
    // A raised midrib between two hollow halves whose edges turn back to the bell.
    const float relief = outline * (0.035f * (1.0f - std::abs(across)) - 0.04f * across * across);
    const glm::vec2 point = midrib(along) + front * (relief - behind * (1.0f - across * across));
    const float angle = x / point.x;
    return {point.x * std::sin(angle), point.y, point.x * std::cos(angle)};
  }
};

void addLeaf(Mesh& mesh, const Leaf& leaf) {
  constexpr float kThickness = 0.03f;
  addPatch(mesh, [&](float u, float v) { return leaf.at(2.0f * u - 1.0f, v, 0.0f); }, {4, 5});
  // The back shares the front's borders, so the leaf is a closed shell.
  const auto back = [&](float u, float v) {
    return leaf.at(1.0f - 2.0f * u, v, kThickness * std::sin(glm::pi<float>() * v));
  };
  addPatch(mesh, back, {2, 5});
}

void addLeaves(Mesh& mesh, const Leaf& leaf, float firstTurn) {
  Mesh one;
  addLeaf(one, leaf);
  for (int i = 0; i < kLeavesInARow; ++i) {
    const float angle =
        glm::two_pi<float>() * (static_cast<float>(i) + firstTurn) / static_cast<float>(kLeavesInARow);
    addMesh(mesh, one, glm::rotate(glm::mat4(1.0f), angle, {0, 1, 0}));
  }
}

/// A stalk that rises along the bell and rolls up under a corner of the abacus, in the plane of x and y.
void addVolute(Mesh& mesh) {
  std::vector<glm::vec3> path{{0.34f, 0.3f, 0.0f}, {0.37f, 0.42f, 0.0f}, {0.43f, 0.53f, 0.0f}};
  const glm::vec3 eye(0.55f, 0.545f, 0.0f);
  constexpr int kSpiralSegments = 11;
  for (int i = 0; i <= kSpiralSegments; ++i) {
    const float t = static_cast<float>(i) / kSpiralSegments;
    const float angle = glm::radians(140.0f - 520.0f * t);
    const float radius = glm::mix(0.088f, 0.028f, t);
    path.push_back(eye + radius * glm::vec3(std::cos(angle), std::sin(angle), 0.0f));
  }
  addSweep(mesh, modelling::rectangleOutline(0.028f, 0.075f), path, false, 60.0f, {0, 0, 1});
}

void addVolutes(Mesh& mesh) {
  Mesh one;
  addVolute(one);
  for (int corner = 0; corner < 4; ++corner) {
    const float angle = glm::half_pi<float>() * (static_cast<float>(corner) + 0.5f);
    addMesh(mesh, one, glm::rotate(glm::mat4(1.0f), angle, {0, 1, 0}));
  }
}

/// A square slab with hollowed sides and cut corners.
std::vector<glm::vec2> abacusOutline(float halfWidth) {
  constexpr float kCorner = 0.07f;
  constexpr float kHollow = 0.09f;
  std::vector<glm::vec2> outline;
  for (int side = 0; side < 4; ++side) {
    const float turn = glm::half_pi<float>() * static_cast<float>(side);
    const glm::vec2 out(std::cos(turn), std::sin(turn));
    const glm::vec2 along(-out.y, out.x);
    for (int i = 0; i <= 4; ++i) {
      const float t = static_cast<float>(i) / 2.0f - 1.0f;
      outline.push_back((halfWidth - kHollow * (1.0f - t * t)) * out + t * (halfWidth - kCorner) * along);
    }
  }
  return outline;
}

void addAbacus(Mesh& mesh) {
  const glm::mat4 upright = glm::rotate(glm::mat4(1.0f), -glm::half_pi<float>(), {1, 0, 0});
  const auto addSlab = [&](float bottom, float top, float halfWidth) {
    const std::size_t first = mesh.vertices.size();
    addExtrusion(mesh, abacusOutline(halfWidth), top - bottom, 30.0f);
    modelling::transformFrom(mesh, first, glm::translate(glm::mat4(1.0f), {0, bottom, 0}) * upright);
  };
  addSlab(kAbacusBottom, kAbacusBottom + 0.05f, 0.56f);
  addSlab(kAbacusBottom + 0.045f, kCapitalHeight, 0.61f);
}

}  // namespace

void addCapital(Mesh& mesh) {
  addBell(mesh);
  addLeaves(mesh, {.height = 0.27f, .halfWidth = 0.122f, .curl = 0.15f, .bottom = 0.0f}, 0.0f);
  addLeaves(mesh, {.height = 0.47f, .halfWidth = 0.115f, .curl = 0.19f, .bottom = 0.03f}, 0.5f);
  addVolutes(mesh);
  addAbacus(mesh);
}

}  // namespace host::hall
