#include "host/scene/builtin/furniture_desk_things.h"

#include <array>

#include "host/scene/builtin/furniture_books.h"
#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addBox;

constexpr float kKey = 0.0165f;
constexpr float kKeyPitch = 0.019f;

// The keys' widths of a row, in keys; together 13 wide.
using KeyRow = std::vector<float>;

// A key cap: a frustum without a bottom, which nobody can see.
void addKey(Mesh& mesh, glm::vec3 base, float width) {
  constexpr float kHeight = 0.006f;
  constexpr float kTaper = 0.0022f;
  const auto corner = [&](float x, float z, float y) {
    const float inset = y > 0.0f ? kTaper : 0.0f;
    return base + glm::vec3(x * (0.5f * width - inset), y, z * (0.5f * kKey - inset));
  };
  const std::array<glm::vec2, 4> turn{glm::vec2(-1, 1), {1, 1}, {1, -1}, {-1, -1}};
  for (std::size_t i = 0; i < turn.size(); ++i) {
    const glm::vec2 a = turn[i];
    const glm::vec2 b = turn[(i + 1) % turn.size()];
    const auto flank = [&](float u, float v) {
      return glm::mix(glm::mix(corner(a.x, a.y, 0.0f), corner(b.x, b.y, 0.0f), u),
                      glm::mix(corner(a.x, a.y, kHeight), corner(b.x, b.y, kHeight), u), v);
    };
    modelling::addPatch(mesh, flank, {1, 1});
  }
  const glm::vec3 origin = corner(-1, 1, kHeight);
  modelling::addQuad(mesh, origin, corner(1, 1, kHeight) - origin, corner(-1, -1, kHeight) - origin);
}

}  // namespace

Piece monitor() {
  Piece piece("monitor");
  constexpr glm::vec2 kScreen{0.53f, 0.315f};
  constexpr float kCentre = 0.34f;
  Mesh& plastic = piece.part(Finish::blackPlastic);
  addRoundedBoard(plastic, {0.24f, 0.19f}, 0.03f, 0.0f, 0.012f, 2);
  const std::array<glm::vec3, 3> neck{glm::vec3(0, 0.01f, -0.06f), {0, 0.2f, -0.065f}, {0, 0.34f, -0.05f}};
  modelling::addSweep(plastic, modelling::rectangleOutline(0.06f, 0.022f), neck, false, 40.0f, {0, 0, 1});

  // The case: a frame about the screen, which lies 3 mm back, and a thick middle behind it.
  const std::array<glm::vec2, 5> section{
      glm::vec2(0.0f, -0.022f), {0.011f, -0.022f}, {0.011f, -0.002f}, {0.009f, 0.0f}, {0.0f, 0.0f}};
  const std::size_t first = plastic.vertices.size();
  addFrame(plastic, kScreen, section);
  addBox(plastic, {-0.5f * kScreen.x, -0.5f * kScreen.y, -0.022f},
         {0.5f * kScreen.x, 0.5f * kScreen.y, -0.006f});
  addBox(plastic, {-0.15f, -0.1f, -0.045f}, {0.15f, 0.1f, -0.022f});
  const glm::mat4 tilt = at({0.0f, kCentre, 0.0f}) * turned(-4.0f, {1, 0, 0});
  modelling::transformFrom(plastic, first, tilt);

  Mesh& screen = piece.part(Finish::screen);
  modelling::addQuad(screen, {-0.5f * kScreen.x, -0.5f * kScreen.y, -0.003f}, {kScreen.x, 0, 0},
                     {0, kScreen.y, 0});
  // One repeat of the picture fills the screen, whatever its size.
  for (Vertex& vertex : screen.vertices)
    vertex.uv = glm::vec2(0.5f + vertex.position.x / kScreen.x, 0.5f - vertex.position.y / kScreen.y) *
                glm::vec2(0.5f, 0.3125f);
  modelling::transformFrom(screen, 0, tilt);
  return piece;
}

Piece keyboard() {
  Piece piece("keyboard");
  const std::array<KeyRow, 5> rows{KeyRow{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2},
                                   {1.5f, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1.5f},
                                   {1.75f, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2.25f},
                                   {2.25f, 1, 1, 1, 1, 1, 1, 1, 1, 2.75f},
                                   {2.0f, 1.5f, 6.0f, 1.5f, 2.0f}};
  constexpr float kWidth = 13.0f * kKeyPitch;
  constexpr float kDepth = 5.0f * kKeyPitch;
  addBox(piece.part(Finish::blackPlastic), {-0.5f * kWidth - 0.008f, 0.0f, -0.5f * kDepth - 0.008f},
         {0.5f * kWidth + 0.008f, 0.014f, 0.5f * kDepth + 0.008f}, 0.003f);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    float x = -0.5f * kWidth;
    const float z = -0.5f * kDepth + (static_cast<float>(row) + 0.5f) * kKeyPitch;
    for (const float width : rows[row]) {
      addKey(piece.part(Finish::keycap), {x + 0.5f * width * kKeyPitch, 0.0139f, z},
             width * kKeyPitch - 0.0025f);
      x += width * kKeyPitch;
    }
  }
  return piece;
}

Piece mouse() {
  Piece piece("mouse");
  const auto shell = [](float u, float v) {
    glm::vec3 p = superellipsoid({0.031f, 0.019f, 0.055f}, {0.8f, 0.7f}, u, v);
    p.y = p.y < 0.0f ? 0.35f * p.y : p.y * (1.0f + 3.0f * p.z);
    return p + glm::vec3(0.0f, 0.0066f, 0.0f);
  };
  modelling::addPatch(piece.part(Finish::blackPlastic), shell, {10, 5});
  const std::array<TubePoint, 5> lead{TubePoint{{0, 0.006f, -0.05f}, 0.0018f},
                                      {{0.006f, 0.002f, -0.1f}, 0.0018f},
                                      {{-0.012f, 0.002f, -0.19f}, 0.0018f},
                                      {{0.008f, 0.002f, -0.27f}, 0.0018f},
                                      {{0.0f, 0.002f, -0.36f}, 0.0018f}};
  addTube(piece.part(Finish::blackPlastic), lead, {3, 8});
  return piece;
}

Piece letterTrays() {
  Piece piece("letter trays");
  constexpr glm::vec2 kHalf{0.125f, 0.165f};
  constexpr float kPitch = 0.068f;
  Mesh& steel = piece.part(Finish::darkSteel);
  for (int tray = 0; tray < 3; ++tray) {
    const float y = 0.008f + kPitch * static_cast<float>(tray);
    addBox(steel, {-kHalf.x, y, -kHalf.y}, {kHalf.x, y + 0.002f, kHalf.y});
    addBox(steel, {-kHalf.x, y + 0.002f, -kHalf.y}, {kHalf.x, y + 0.03f, -kHalf.y + 0.002f});
    for (const float side : {-1.0f, 1.0f}) {
      const float x = side * (kHalf.x - 0.001f);
      addBox(steel, {x - 0.001f, y + 0.002f, -kHalf.y + 0.002f}, {x + 0.001f, y + 0.03f, kHalf.y});
    }
    if (tray < 2)
      piece.add(paperStack(3 + 2 * tray, 71 + static_cast<std::uint32_t>(tray)), at({0, y + 0.0022f, 0}));
  }
  for (const float x : {-kHalf.x - 0.003f, kHalf.x + 0.003f}) {
    for (const float z : {-kHalf.y + 0.03f, kHalf.y - 0.03f})
      addRod(steel, {x, 0.0f, z}, {x, 2.0f * kPitch + 0.04f, z}, 0.0032f, 4);
  }
  return piece;
}

Piece penCup() {
  Piece piece("pen cup");
  const std::array<glm::vec2, 7> profile{glm::vec2(0.0f, 0.0f), {0.038f, 0.0f}, {0.04f, 0.002f},
                                         {0.04f, 0.1f},         {0.038f, 0.1f}, {0.038f, 0.004f},
                                         {0.0f, 0.004f}};
  modelling::addLathe(piece.part(Finish::darkSteel), glm::vec3(0.0f), profile, 14);
  const std::array<Finish, 5> inks{Finish::coverRed, Finish::coverBlue, Finish::coverBlack,
                                   Finish::coverOchre, Finish::coverGreen};
  for (std::size_t i = 0; i < inks.size(); ++i) {
    const float angle = 1.2566371f * static_cast<float>(i) + 0.3f;
    const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle));
    const glm::vec3 tip = out * 0.033f + glm::vec3(0.0f, 0.1f, 0.0f);
    const glm::vec3 foot = -out * 0.012f + glm::vec3(0.0f, 0.006f, 0.0f);
    addRod(piece.part(inks[i]), foot, foot + (tip - foot) * (1.5f + 0.08f * static_cast<float>(i)), 0.0038f,
           5);
  }
  return piece;
}

Piece telephone() {
  Piece piece("telephone");
  Mesh& plastic = piece.part(Finish::blackPlastic);
  const std::array<glm::vec2, 5> side{
      glm::vec2(-0.1f, 0.0f), {0.1f, 0.0f}, {0.1f, 0.018f}, {-0.06f, 0.055f}, {-0.1f, 0.055f}};
  modelling::addExtrusion(plastic, side, 0.18f);
  // The side view lies in xy, its front at +x: turn that to +Z.
  modelling::transformFrom(plastic, 0, turned(-90.0f, {0, 1, 0}) * at({0.0f, 0.0f, -0.09f}));
  const auto handset =
      modelling::arcPath({-0.055f, -0.13f, 0.0f}, {0.0f, 0.0f, 0.26f}, {0.0f, 0.2f, 0.0f}, 1.22f, 1.92f, 6);
  modelling::addSweep(plastic, modelling::rectangleOutline(0.026f, 0.022f), handset);
  for (const float z : {-0.085f, 0.085f}) addBlock(plastic, {-0.055f, 0.034f, z}, {0.042f, 0.035f, 0.042f});
  for (int key = 0; key < 12; ++key) {
    const int keyRow = key / 3;
    const auto column = static_cast<float>(key % 3);
    const auto row = static_cast<float>(keyRow);
    const float z = -0.02f + 0.022f * row;
    const float slope = 0.055f - 0.037f / 0.16f * (z + 0.06f);
    addBlock(piece.part(Finish::greyPlastic), {0.012f + 0.024f * column, slope - 0.004f, z},
             {0.016f, 0.0065f, 0.012f});
  }
  return piece;
}

Piece laptop() {
  Piece piece("laptop");
  constexpr float kHalf = 0.16f;
  Mesh& metal = piece.part(Finish::greyPlastic);
  addBox(metal, {-kHalf, 0.002f, -0.11f}, {kHalf, 0.016f, 0.11f});
  addBox(piece.part(Finish::keycap), {-0.135f, 0.0155f, -0.075f}, {0.135f, 0.0172f, 0.025f});
  addBox(piece.part(Finish::paintedSteel), {-0.05f, 0.0155f, 0.04f}, {0.05f, 0.0165f, 0.098f});
  for (const float x : {-0.13f, 0.13f}) {
    for (const float z : {-0.09f, 0.09f}) addBlock(metal, {x, 0.0f, z}, {0.014f, 0.003f, 0.014f});
  }
  const glm::mat4 lid = at({0.0f, 0.014f, -0.106f}) * turned(-18.0f, {1, 0, 0});
  const std::size_t first = metal.vertices.size();
  addBox(metal, {-kHalf, 0.0f, -0.007f}, {kHalf, 0.215f, 0.0f});
  modelling::transformFrom(metal, first, lid);
  Mesh& screen = piece.part(Finish::screen);
  modelling::addQuad(screen, {-0.15f, 0.012f, 0.0004f}, {0.3f, 0, 0}, {0, 0.19f, 0});
  for (Vertex& vertex : screen.vertices)
    vertex.uv = glm::vec2(0.5f + vertex.position.x / 0.3f, 1.0f - (vertex.position.y - 0.012f) / 0.19f) *
                glm::vec2(0.5f, 0.3125f);
  modelling::transformFrom(screen, 0, lid);
  return piece;
}

Piece cable(glm::vec3 from, glm::vec3 to, float sag) {
  Piece piece("cable");
  const glm::vec3 down(0.0f, -sag, 0.0f);
  const std::array<TubePoint, 5> line{TubePoint{from, 0.004f},
                                      {glm::mix(from, to, 0.25f) + 0.75f * down, 0.004f},
                                      {glm::mix(from, to, 0.5f) + down, 0.004f},
                                      {glm::mix(from, to, 0.75f) + 0.75f * down, 0.004f},
                                      {to, 0.004f}};
  addTube(piece.part(Finish::blackPlastic), line, {4, 8});
  return piece;
}

}  // namespace host::furniture
