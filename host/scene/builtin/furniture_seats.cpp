#include "host/scene/builtin/furniture_seats.h"

#include <array>
#include <cmath>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

constexpr float kSeatHeight = 0.44f;
constexpr float kHalfFront = 0.205f;
constexpr float kHalfBack = 0.18f;
constexpr float kFrontZ = 0.19f;
constexpr float kBackZ = -0.19f;
constexpr int kTurnedSegments = 16;

void addTurnedLeg(Mesh& mesh, glm::vec3 foot, float height) {
  const std::array<glm::vec2, 20> profile{
      glm::vec2(0.0f, 0.0f), {0.012f, 0.0f},   {0.016f, 0.008f}, {0.017f, 0.03f},  {0.012f, 0.05f},
      {0.014f, 0.09f},       {0.019f, 0.18f},  {0.021f, 0.24f},  {0.018f, 0.275f}, {0.013f, 0.287f},
      {0.021f, 0.296f},      {0.023f, 0.304f}, {0.021f, 0.312f}, {0.014f, 0.321f}, {0.019f, 0.331f},
      {0.02f, 0.338f},       {0.019f, 0.345f}, {0.016f, 0.352f}, {0.02f, 0.37f},   {0.02f, 0.44f}};
  std::vector<glm::vec2> scaled;
  scaled.reserve(std::size(profile) + 1);
  for (const glm::vec2 point : profile) scaled.emplace_back(point.x, point.y * height / 0.44f);
  scaled.emplace_back(0.0f, height);
  modelling::addLathe(mesh, foot, scaled, kTurnedSegments);
}

// A stretcher: a bar that swells in the middle, into both legs.
void addStretcher(Mesh& mesh, glm::vec3 from, glm::vec3 to) {
  const std::array<TubePoint, 5> points{TubePoint{from, 0.007f},
                                        {glm::mix(from, to, 0.3f), 0.009f},
                                        {glm::mix(from, to, 0.5f), 0.012f},
                                        {glm::mix(from, to, 0.7f), 0.009f},
                                        {to, 0.007f}};
  addTube(mesh, points, {10, 12});
}

// The middle line of a back post, raked and curved backwards above the seat.
glm::vec3 postAt(float side, float t) {
  const std::array<TubePoint, 5> line{TubePoint{{side * 0.178f, 0.0f, -0.24f}, 0},
                                      {{side * 0.18f, 0.22f, -0.2f}, 0},
                                      {{side * kHalfBack, 0.44f, kBackZ}, 0},
                                      {{side * 0.19f, 0.7f, -0.215f}, 0},
                                      {{side * 0.2f, 0.96f, -0.275f}, 0}};
  return alongCurve(line, t).position;
}

// Points between the two posts at the height of `t`, bowed backwards.
std::vector<glm::vec3> bowedRail(float t, float bow, int segments) {
  std::vector<glm::vec3> path;
  for (int i = 0; i <= segments; ++i) {
    const float u = static_cast<float>(i) / static_cast<float>(segments);
    const glm::vec3 straight = glm::mix(postAt(-1.0f, t), postAt(1.0f, t), u);
    path.push_back(straight - glm::vec3(0.0f, 0.0f, bow * 4.0f * u * (1.0f - u)));
  }
  return path;
}

void addBack(Mesh& wood) {
  for (const float side : {-1.0f, 1.0f}) {
    std::vector<glm::vec3> path;
    for (int i = 0; i <= 20; ++i) path.push_back(postAt(side, static_cast<float>(i) / 20.0f));
    modelling::addSweep(wood, modelling::rectangleOutline(0.032f, 0.034f), path, false, 40.0f, {0, 0, 1});
  }
  constexpr float kLow = 0.58f;
  constexpr float kHigh = 0.95f;
  modelling::addSweep(wood, modelling::rectangleOutline(0.018f, 0.075f), bowedRail(kHigh, 0.03f, 16));
  modelling::addSweep(wood, modelling::rectangleOutline(0.018f, 0.04f), bowedRail(kLow, 0.018f, 12));
  const auto top = bowedRail(kHigh, 0.03f, 12);
  const auto bottom = bowedRail(kLow, 0.018f, 12);
  for (int slat = 1; slat <= 5; ++slat) {
    const glm::vec3 from = bottom[slat * 2];
    const glm::vec3 to = top[slat * 2];
    const std::array<TubePoint, 3> line{
        TubePoint{from, 0}, {glm::mix(from, to, 0.5f) + glm::vec3(0, 0, 0.014f), 0}, {to, 0}};
    std::vector<glm::vec3> path;
    for (int i = 0; i <= 10; ++i) path.push_back(alongCurve(line, static_cast<float>(i) / 10.0f).position);
    modelling::addSweep(wood, modelling::rectangleOutline(0.03f, 0.009f), path, false, 40.0f, {0, 0, 1});
  }
}

void addSeatFrame(Mesh& wood) {
  // The four rails, tenoned into legs and posts, below the seat board.
  const auto rail = [&](glm::vec3 from, glm::vec3 to) {
    modelling::addSweep(wood, modelling::rectangleOutline(0.02f, 0.055f), std::array<glm::vec3, 2>{from, to});
  };
  constexpr float kRail = kSeatHeight - 0.04f;
  rail({-kHalfFront, kRail, kFrontZ}, {kHalfFront, kRail, kFrontZ});
  rail({-kHalfBack, kRail, kBackZ}, {kHalfBack, kRail, kBackZ});
  for (const float side : {-1.0f, 1.0f})
    rail({side * kHalfBack, kRail, kBackZ}, {side * kHalfFront, kRail, kFrontZ});
}

}  // namespace

Piece slatBackChair() {
  Piece chair("slat-back chair");
  Mesh& wood = chair.part(Finish::oak);
  addBack(wood);
  addSeatFrame(wood);
  for (const float side : {-1.0f, 1.0f}) {
    addTurnedLeg(wood, {side * kHalfFront, 0.0f, kFrontZ}, kSeatHeight - 0.008f);
    addStretcher(wood, {side * kHalfFront, 0.16f, kFrontZ}, postAt(side, 0.19f));
  }
  addStretcher(wood, {-kHalfFront, 0.21f, kFrontZ}, {kHalfFront, 0.21f, kFrontZ});
  addStretcher(wood, {-0.193f, 0.163f, 0.0f}, {0.193f, 0.163f, 0.0f});

  // The seat tapers towards the back; its front edge rolls over.
  const auto seat = [](float u, float v) {
    glm::vec3 p = superellipsoid({0.235f, 0.03f, 0.225f}, {0.35f, 0.5f}, u, v);
    p.x *= 0.93f + 0.28f * p.z;
    p.y += 0.006f * std::cos(6.0f * p.x) * std::cos(6.0f * p.z);
    return p + glm::vec3(0.0f, kSeatHeight + 0.012f, 0.025f);
  };
  modelling::addPatch(chair.part(Finish::cushionFabric), seat, {40, 14});
  return chair;
}

Piece bench(float width) {
  Piece piece("bench");
  Mesh& wood = piece.part(Finish::oak);
  constexpr float kHeight = 0.45f;
  constexpr float kDepth = 0.36f;
  addTableTop(wood, {width, kDepth}, 0.03f, kHeight - 0.035f, kHeight, 5);
  const float x = width * 0.5f - 0.1f;
  const float z = kDepth * 0.5f - 0.06f;
  const auto apron = [&](glm::vec3 from, glm::vec3 to) {
    modelling::addSweep(wood, modelling::rectangleOutline(0.02f, 0.07f), std::array<glm::vec3, 2>{from, to});
  };
  constexpr float kApron = kHeight - 0.068f;
  for (const float side : {-1.0f, 1.0f}) {
    addTurnedLeg(wood, {side * x, 0.0f, z}, kHeight - 0.035f);
    addTurnedLeg(wood, {side * x, 0.0f, -z}, kHeight - 0.035f);
    apron({side * x, kApron, -z}, {side * x, kApron, z});
    apron({-x, kApron, side * z}, {x, kApron, side * z});
    addStretcher(wood, {side * x, 0.17f, -z}, {side * x, 0.17f, z});
  }
  addStretcher(wood, {-x, 0.17f, 0.0f}, {x, 0.17f, 0.0f});
  addCushion(piece.part(Finish::cushionFabric), {0.0f, kHeight + 0.0245f, 0.0f},
             {width * 0.49f, 0.025f, kDepth * 0.48f}, {0.22f, 0.45f}, {72, 12});
  return piece;
}

}  // namespace host::furniture
