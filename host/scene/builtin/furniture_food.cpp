#include <array>
#include <cmath>

#include "host/scene/builtin/furniture_shapes.h"
#include "host/scene/builtin/furniture_tableware.h"

namespace host::furniture {

namespace {

using modelling::addLathe;
using Profile = std::vector<glm::vec2>;

constexpr int kFruitSegments = 32;

// Fruit are centred on the origin, so that they can be heaped by the positions of their middles.
Piece apple() {
  Piece piece("apple");
  addLathe(piece.part(Finish::apple), glm::vec3(0.0f),
           Profile{{0.0f, -0.029f},
                   {0.006f, -0.032f},
                   {0.014f, -0.034f},
                   {0.024f, -0.029f},
                   {0.033f, -0.017f},
                   {0.038f, -0.001f},
                   {0.038f, 0.012f},
                   {0.033f, 0.025f},
                   {0.024f, 0.0325f},
                   {0.014f, 0.033f},
                   {0.006f, 0.029f},
                   {0.0f, 0.023f}},
           kFruitSegments, 60.0f);
  const std::array<TubePoint, 3> stalk{
      TubePoint{{0, 0.022f, 0}, 0.0012f}, {{0.002f, 0.035f, 0}, 0.0012f}, {{0.007f, 0.045f, 0}, 0.0018f}};
  addTube(piece.part(Finish::bark), stalk, {6, 6});
  return piece;
}

Piece pear() {
  Piece piece("pear");
  addLathe(piece.part(Finish::pear), glm::vec3(0.0f),
           Profile{{0.0f, -0.034f},
                   {0.01f, -0.037f},
                   {0.022f, -0.034f},
                   {0.033f, -0.023f},
                   {0.037f, -0.008f},
                   {0.034f, 0.009f},
                   {0.026f, 0.025f},
                   {0.019f, 0.04f},
                   {0.0155f, 0.053f},
                   {0.01f, 0.062f},
                   {0.0f, 0.063f}},
           kFruitSegments, 60.0f);
  addRod(piece.part(Finish::bark), {0, 0.061f, 0}, {0.004f, 0.082f, 0.001f}, 0.0014f, 6);
  return piece;
}

Piece orange() {
  Piece piece("orange");
  modelling::addEllipsoid(piece.part(Finish::orange), glm::vec3(0.0f), {0.038f, 0.036f, 0.038f},
                          {kFruitSegments, 20});
  return piece;
}

Piece lemon() {
  Piece piece("lemon");
  addLathe(piece.part(Finish::lemon), glm::vec3(0.0f),
           Profile{{0.0f, -0.041f},
                   {0.004f, -0.039f},
                   {0.008f, -0.034f},
                   {0.017f, -0.026f},
                   {0.025f, -0.013f},
                   {0.027f, 0.0f},
                   {0.025f, 0.013f},
                   {0.017f, 0.026f},
                   {0.008f, 0.034f},
                   {0.004f, 0.039f},
                   {0.0f, 0.041f}},
           kFruitSegments, 60.0f);
  return piece;
}

// A bent roll of dough, thick in the middle, with the ridges of its windings.
Piece croissant() {
  Piece piece("croissant");
  std::vector<TubePoint> line;
  constexpr int kPoints = 30;
  for (int i = 0; i <= kPoints; ++i) {
    const float t = static_cast<float>(i) / kPoints * 2.0f - 1.0f;
    const float body = 0.031f * std::pow(std::max(1.0f - t * t, 0.0f), 0.62f) + 0.002f;
    const float ridge = 1.0f + 0.1f * std::abs(std::sin(t * 11.0f));
    const float angle = t * 1.35f;
    line.push_back({{0.072f * std::sin(angle), 0.9f * body, 0.072f * std::cos(angle) - 0.04f}, body * ridge});
  }
  addTube(piece.part(Finish::crust), line, {20, kPoints});
  return piece;
}

Piece roll() {
  Piece piece("roll");
  const auto dough = [](float u, float v) {
    glm::vec3 p = superellipsoid({0.043f, 0.027f, 0.034f}, {0.95f, 0.85f}, u, v);
    const float score = std::exp(-p.z * p.z * 9000.0f) * glm::smoothstep(0.008f, 0.024f, p.y);
    p.y += p.y < 0.0f ? -0.3f * p.y : -0.007f * score;
    return p + glm::vec3(0.0f, 0.019f, 0.0f);
  };
  modelling::addPatch(piece.part(Finish::crust), dough, {36, 22});
  return piece;
}

}  // namespace

Piece foldedNapkin() {
  Piece piece("napkin");
  Mesh& cloth = piece.part(Finish::napkin);
  // Folded in four: layers that don't quite meet at their edges.
  constexpr int kLayers = 3;
  for (int i = 0; i < kLayers; ++i) {
    const auto layer = static_cast<float>(i);
    const auto fold = [&](float u, float v) {
      const glm::vec3 radii(0.052f - 0.0015f * layer, 0.0021f, 0.098f - 0.003f * layer);
      glm::vec3 p = superellipsoid(radii, {0.16f, 0.6f}, u, v);
      p.y += 0.0021f + 0.0036f * layer +
             0.0006f * (1.0f + std::sin(38.0f * p.z + layer) * std::cos(31.0f * p.x));
      return p + glm::vec3(0.0012f * layer, 0.0f, 0.001f * layer);
    };
    modelling::addPatch(cloth, fold, {28, 6});
  }
  return piece;
}

Piece fruitBowl() {
  Piece piece("fruit bowl");
  addLathe(piece.part(Finish::sageGlaze), glm::vec3(0.0f),
           Profile{{0.0f, 0.005f},
                   {0.058f, 0.005f},
                   {0.061f, 0.0f},
                   {0.069f, 0.0f},
                   {0.071f, 0.007f},
                   {0.095f, 0.02f},
                   {0.122f, 0.042f},
                   {0.142f, 0.068f},
                   {0.151f, 0.086f},
                   {0.1515f, 0.089f},
                   {0.1495f, 0.0905f},
                   {0.147f, 0.089f},
                   {0.137f, 0.069f},
                   {0.117f, 0.045f},
                   {0.09f, 0.024f},
                   {0.06f, 0.014f},
                   {0.0f, 0.012f}},
           72);
  piece.add(orange(), at({0.058f, 0.062f, 0.03f}, 20.0f));
  piece.add(orange(), at({-0.012f, 0.058f, 0.068f}, 100.0f));
  piece.add(apple(), at({-0.064f, 0.062f, 0.012f}, 200.0f) * turned(24.0f, {1, 0, 0}));
  piece.add(apple(), at({0.036f, 0.064f, -0.058f}, 10.0f) * turned(-30.0f, {1, 0, 1}));
  piece.add(lemon(), at({-0.044f, 0.058f, -0.065f}, 60.0f) * turned(82.0f, {0, 0, 1}));
  piece.add(apple(), at({0.002f, 0.108f, 0.0f}, 80.0f) * turned(14.0f, {0, 0, 1}));
  piece.add(lemon(), at({0.066f, 0.116f, -0.022f}, 130.0f) * turned(72.0f, {0, 0, 1}));
  piece.add(pear(), at({-0.058f, 0.125f, 0.055f}, 300.0f) * turned(62.0f, {1, 0, 0.3f}));
  return piece;
}

Piece breadBasket() {
  Piece piece("bread basket");
  addLathe(piece.part(Finish::wicker), glm::vec3(0.0f),
           Profile{{0.0f, 0.0f},
                   {0.105f, 0.0f},
                   {0.112f, 0.006f},
                   {0.124f, 0.03f},
                   {0.136f, 0.06f},
                   {0.134f, 0.063f},
                   {0.13f, 0.061f},
                   {0.118f, 0.031f},
                   {0.105f, 0.008f},
                   {0.0f, 0.006f}},
           64);
  // Two strands twisted around the rim.
  for (const float phase : {0.0f, 3.1415927f}) {
    std::vector<glm::vec3> strand;
    constexpr int kSteps = 132;
    for (int i = 0; i < kSteps; ++i) {
      const float turn = 6.2831853f * static_cast<float>(i) / kSteps;
      const float twist = 20.0f * turn + phase;
      const float r = 0.134f + 0.0035f * std::cos(twist);
      strand.emplace_back(r * std::cos(turn), 0.063f + 0.0035f * std::sin(twist), -r * std::sin(turn));
    }
    std::vector<TubePoint> points;
    points.reserve(strand.size() + 1);
    for (const glm::vec3 p : strand) points.push_back({p, 0.0042f});
    points.push_back(points.front());
    addTube(piece.part(Finish::wicker), points, {6, kSteps});
  }
  // A cloth laid into the basket, its edge hanging over the rim in waves.
  const auto cloth = [](float u, float v) {
    const float angle = 6.2831853f * u;
    const float wave = std::sin(7.0f * angle) + 0.5f * std::sin(11.0f * angle + 1.0f);
    const float r = 0.1f * v + 0.045f * std::max(v - 0.35f, 0.0f) + (v > 0.8f ? 0.05f * (v - 0.8f) : 0.0f);
    const float inside = 0.008f + 0.07f * glm::smoothstep(0.62f, 0.95f, v);
    return glm::vec3((r + 0.006f * wave * v * v) * std::sin(angle), inside + 0.006f * wave * v * v * v,
                     (r + 0.006f * wave * v * v) * std::cos(angle));
  };
  modelling::addPatch(piece.part(Finish::napkin), [&](float u, float v) { return cloth(u, 1.0f - v); },
                      {60, 12});
  piece.add(croissant(), at({-0.03f, 0.014f, 0.035f}, 15.0f));
  piece.add(croissant(), at({0.03f, 0.016f, -0.045f}, 190.0f));
  piece.add(roll(), at({-0.062f, 0.018f, -0.03f}, 70.0f));
  piece.add(croissant(), at({0.01f, 0.062f, 0.0f}, 95.0f));
  return piece;
}

Piece loafOnBoard() {
  Piece piece("loaf");
  addTableTop(piece.part(Finish::walnut), {0.38f, 0.2f}, 0.03f, 0.0f, 0.02f, 6);
  const auto loaf = [](float u, float v) {
    glm::vec3 p = superellipsoid({0.052f, 0.1f, 0.052f}, {0.8f, 0.6f}, u, v);
    const float across = 0.04f * std::sin(p.y * 90.0f);
    const float score = std::exp(-across * across * 6000.0f) * glm::smoothstep(0.02f, 0.045f, p.z);
    p.z -= 0.006f * score;
    if (p.z < 0.0f) p.z *= 0.75f;
    return glm::vec3(p.y - 0.05f, p.z + 0.059f, p.x);
  };
  modelling::addPatch(piece.part(Finish::crust), loaf, {44, 48});
  // Slices that lean against each other.
  for (int i = 0; i < 3; ++i) {
    const std::size_t first = piece.part(Finish::crust).vertices.size();
    addCushion(piece.part(Finish::crust), glm::vec3(0.0f), {0.047f, 0.043f, 0.006f}, {0.35f, 0.75f},
               {36, 12});
    const float x = 0.085f + 0.026f * static_cast<float>(i);
    modelling::transformFrom(
        piece.part(Finish::crust), first,
        at({x, 0.0535f, 0.0f}, 90.0f) * turned(-22.0f - 6.0f * static_cast<float>(i), {1, 0, 0}));
  }
  return piece;
}

}  // namespace host::furniture
