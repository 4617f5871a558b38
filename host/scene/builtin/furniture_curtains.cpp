#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/furniture_shapes.h"
#include "host/scene/builtin/furniture_windows.h"

namespace host::furniture {

namespace {

constexpr float kRingRadius = 0.024f;
constexpr float kRailRadius = 0.014f;

// The folds of one curtain: waves of uneven width that widen and wander on their way down.
class Folds {
 public:
  explicit Folds(const CurtainShape& shape) : shape_(shape), random_(shape.seed) {
    for (int i = 0; i <= shape.folds; ++i) jitter_.push_back(random_.between(-0.22f, 0.22f));
    drift_ = {random_.between(0.0f, 6.0f), random_.between(0.0f, 6.0f)};
  }

  /// u from left to right, v from the hem up.
  [[nodiscard]] glm::vec3 at(float u, float v) const {
    const float down = 1.0f - v;
    const float phase = phaseAt(u) + 0.35f * down * std::sin(drift_.x + 5.0f * u + 2.0f * down);
    const float depth = shape_.foldDepth * (0.55f + 0.45f * std::sqrt(down)) *
                        (1.0f + 0.3f * std::sin(drift_.y + 7.0f * u + 3.0f * down));
    // The wave's overhang: at the flanks the cloth runs back under its own crest, as real folds do.
    const float overhang = 0.16f * shape_.width / static_cast<float>(shape_.folds) * std::sin(2.0f * phase);
    const float x = ((u - 0.5f) * shape_.width - overhang) * waist(v);
    const float z = depth * std::sin(phase) * std::sqrt(waist(v)) + 0.012f * std::sin(drift_.x + 2.3f * down);
    return {x, v * shape_.height, z};
  }

 private:
  // Folds of uneven width: the phase runs through the jittered borders.
  [[nodiscard]] float phaseAt(float u) const {
    const float scaled = u * static_cast<float>(shape_.folds);
    const int i = std::min(static_cast<int>(scaled), shape_.folds - 1);
    const float f = scaled - static_cast<float>(i);
    const float smooth = f * f * (3.0f - 2.0f * f);
    const float shift = glm::mix(jitter_[i], jitter_[i + 1], smooth);
    return (scaled + shift) * glm::two_pi<float>();
  }

  // How much of its width the curtain keeps: all at the top, less at the tie-back, more again below.
  [[nodiscard]] float waist(float v) const {
    constexpr float kTieHeight = 0.38f;
    const float distance = (v - kTieHeight) / (v > kTieHeight ? 0.42f : 0.3f);
    return 1.0f - shape_.gather * std::exp(-distance * distance * 2.2f);
  }

  CurtainShape shape_;
  Random random_;
  std::vector<float> jitter_;
  glm::vec2 drift_{0.0f};
};

Piece ring() {
  Piece piece("curtain ring");
  const auto circle = modelling::arcPath(glm::vec3(0.0f), {0, kRingRadius, 0}, {0, 0, kRingRadius}, 0.0f,
                                         glm::two_pi<float>() * 19.0f / 20.0f, 19);
  modelling::addSweep(piece.part(Finish::brass), modelling::circleOutline(0.0028f, 6), circle, true, 60.0f,
                      {1.0f, 0.0f, 0.0f});
  return piece;
}

}  // namespace

Piece curtain(const CurtainShape& shape) {
  Piece piece("curtain");
  const Folds folds(shape);
  const glm::ivec2 segments(shape.folds * 12, 28);
  modelling::addPatch(
      piece.part(Finish::curtain), [&](float u, float v) { return folds.at(u, v); }, segments);
  const Piece hook = ring();
  for (int i = 0; i < shape.folds; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(shape.folds);
    const float x = folds.at(u, 1.0f).x;
    piece.add(hook, at({x, shape.height + kRingRadius - 0.006f, 0.0f}, 8.0f * std::sin(9.0f * x)));
  }
  if (shape.gather > 0.0f) {
    // The tie-back goes round the waist at its narrowest.
    const float half = 0.5f * shape.width * (1.0f - shape.gather) + 0.03f;
    const auto loop =
        modelling::arcPath({0.0f, 0.38f * shape.height, 0.0f}, {half, 0.0f, 0.0f}, {0.0f, 0.03f, 0.075f},
                           0.0f, glm::two_pi<float>() * 35.0f / 36.0f, 35);
    modelling::addSweep(piece.part(Finish::cushionFabric), modelling::rectangleOutline(0.006f, 0.05f), loop,
                        true);
  }
  return piece;
}

Piece curtainRail(float width, float standOff) {
  Piece rail("curtain rail");
  Mesh& metal = rail.part(Finish::brass);
  const float half = width * 0.5f;
  addRod(metal, {-half, 0, 0}, {half, 0, 0}, kRailRadius, 16);
  const std::array<glm::vec2, 9> finial{glm::vec2(0.0f, 0.0f), {0.02f, 0.0f},    {0.02f, 0.012f},
                                        {0.012f, 0.018f},      {0.026f, 0.034f}, {0.03f, 0.05f},
                                        {0.026f, 0.066f},      {0.013f, 0.078f}, {0.0f, 0.082f}};
  for (const float side : {-1.0f, 1.0f}) {
    const std::size_t first = metal.vertices.size();
    modelling::addLathe(metal, glm::vec3(0.0f), finial, 20);
    aimFrom(metal, first, {side, 0, 0}, {side * half, 0, 0});
    const float x = side * (half - 0.06f);
    addRod(metal, {x, 0, -standOff}, {x, 0, 0}, 0.008f, 10);
    addRod(metal, {x, 0, -standOff - 0.002f}, {x, 0, -standOff + 0.008f}, 0.028f, 16);
  }
  return rail;
}

}  // namespace host::furniture
