#include "host/scene/builtin/furniture_fittings.h"

#include <array>
#include <cmath>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addBox;

// A ball of paper: an ellipsoid with creases.
void addCrumpledBall(Mesh& mesh, glm::vec3 centre, float radius) {
  const auto ball = [&](float u, float v) {
    const glm::vec3 p = superellipsoid(glm::vec3(1.0f), glm::vec2(1.0f), u, v);
    const float crease =
        std::sin(9.0f * p.x + 3.0f * p.y) * std::sin(8.0f * p.y + 5.0f * p.z) * std::sin(7.0f * p.z);
    return centre + p * radius * (1.0f + 0.22f * crease);
  };
  modelling::addPatch(mesh, ball, {7, 5});
}

// A bar of the ceiling's grid from `from` to `to`: its lower face and its flanks; `half` is half its width
// sideways, with its height in y. Seen from above, the way of the bar is a quarter turn clockwise from that
// sideways direction.
void addCeilingBar(Mesh& mesh, glm::vec3 from, glm::vec3 to, glm::vec3 half) {
  const glm::vec3 side(half.x, 0.0f, half.z);
  const glm::vec3 rise(0.0f, half.y, 0.0f);
  modelling::addQuad(mesh, from - side, to - from, 2.0f * side);
  modelling::addQuad(mesh, from + side, to - from, rise);
  modelling::addQuad(mesh, from - side + rise, to - from, -rise);
}

}  // namespace

Piece radiator(float width, float height) {
  Piece piece("radiator");
  constexpr float kFloor = 0.12f;
  constexpr float kBack = 0.04f;
  constexpr float kFront = 0.1f;
  Mesh& steel = piece.part(Finish::whiteLacquer);
  // The front panel is pressed into upright flutes.
  constexpr float kFlute = 0.13f;
  const int flutes = static_cast<int>(width / kFlute);
  const float left = -0.5f * kFlute * static_cast<float>(flutes);
  std::vector<glm::vec2> outline{{left, kFront - 0.02f}, {-left, kFront - 0.02f}};
  for (int i = flutes; i > 0; --i) {
    const float right = left + kFlute * static_cast<float>(i);
    outline.emplace_back(right, kFront - 0.006f);
    outline.emplace_back(right - 0.012f, kFront);
    outline.emplace_back(right - kFlute + 0.012f, kFront);
  }
  outline.emplace_back(left, kFront - 0.006f);
  addPrism(steel, outline, kFloor + 0.015f, height - 0.03f);
  addBox(steel, {left, kFloor + 0.02f, kBack - 0.01f}, {-left, kFloor + height - 0.02f, kBack + 0.01f});
  addBox(steel, {left - 0.006f, kFloor + height - 0.015f, kBack - 0.012f},
         {-left + 0.006f, kFloor + height, kFront + 0.004f});
  for (const float side : {-1.0f, 1.0f}) {
    addBox(steel, {side * -left - 0.005f, kFloor, kBack - 0.012f},
           {side * -left + 0.005f, kFloor + height - 0.015f, kFront + 0.003f});
  }
  Mesh& chrome = piece.part(Finish::chrome);
  const float x = -left - 0.04f;
  addRod(chrome, {x, 0.0f, 0.07f}, {x, kFloor + 0.03f, 0.07f}, 0.008f, 6);
  addRod(chrome, {left + 0.04f, 0.0f, 0.07f}, {left + 0.04f, kFloor + 0.03f, 0.07f}, 0.008f, 6);
  addRod(piece.part(Finish::paintedSteel), {-left + 0.003f, kFloor + height - 0.08f, 0.07f},
         {-left + 0.09f, kFloor + height - 0.08f, 0.07f}, 0.022f, 8);
  return piece;
}

Piece wasteBasket() {
  Piece piece("waste basket");
  const std::array<glm::vec2, 9> profile{glm::vec2(0.0f, 0.0f), {0.11f, 0.0f},    {0.113f, 0.004f},
                                         {0.146f, 0.3f},        {0.15f, 0.304f},  {0.147f, 0.308f},
                                         {0.142f, 0.304f},      {0.109f, 0.008f}, {0.0f, 0.006f}};
  modelling::addLathe(piece.part(Finish::darkSteel), glm::vec3(0.0f), profile, 16);
  addCrumpledBall(piece.part(Finish::paper), {0.04f, 0.045f, 0.02f}, 0.042f);
  addCrumpledBall(piece.part(Finish::paper), {-0.05f, 0.047f, 0.03f}, 0.04f);
  addCrumpledBall(piece.part(Finish::paper), {-0.005f, 0.048f, -0.06f}, 0.042f);
  return piece;
}

Piece pinBoard(glm::vec2 size, std::uint32_t seed) {
  Piece piece("pin board");
  const glm::vec2 h = size * 0.5f;
  addBox(piece.part(Finish::cork), {-h.x, -h.y, -0.005f}, {h.x, h.y, 0.012f});
  const std::array<glm::vec2, 5> section{
      glm::vec2(0.0f, -0.005f), {0.022f, -0.005f}, {0.022f, 0.016f}, {0.018f, 0.02f}, {0.0f, 0.02f}};
  addFrame(piece.part(Finish::beech), size, section);

  Random random(seed);
  const std::array<Finish, 4> notes{Finish::paper, Finish::coverOchre, Finish::paper, Finish::coverCream};
  constexpr int kColumns = 4;
  constexpr int kRows = 2;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const int row = i / kColumns;
    const glm::vec2 place(i % kColumns, row);
    const glm::vec2 cell = (place + 0.5f) / glm::vec2(kColumns, kRows) - 0.5f;
    const glm::vec2 middle =
        cell * size + glm::vec2(random.between(-0.02f, 0.02f), random.between(-0.02f, 0.02f));
    const bool sheet = notes[i % 4] == Finish::paper;
    const glm::vec2 note = sheet ? glm::vec2(0.21f, 0.297f) : glm::vec2(0.11f, 0.11f);
    Mesh leaf;
    modelling::addBox(leaf, {-0.5f * note.x, -note.y, 0.0f}, {0.5f * note.x, 0.0f, 0.0012f});
    for (Vertex& vertex : leaf.vertices) vertex.uv = {vertex.position.x + 0.5f * note.x, -vertex.position.y};
    const glm::vec3 pin(middle.x, middle.y + 0.45f * note.y, 0.0118f);
    modelling::addMesh(piece.part(notes[i % 4]), leaf,
                       at(pin + glm::vec3(0, 0.012f, 0)) * turned(random.between(-5.0f, 5.0f), {0, 0, 1}));
    addRod(piece.part(i % 2 == 0 ? Finish::coverRed : Finish::coverBlue), pin, pin + glm::vec3(0, 0, 0.012f),
           0.005f, 5);
  }
  return piece;
}

Piece wallClock() {
  Piece piece("wall clock");
  constexpr float kRadius = 0.15f;
  const std::array<glm::vec2, 6> rim{glm::vec2(0.0f, -0.004f),  {kRadius, -0.004f},
                                     {kRadius, 0.03f},          {kRadius - 0.008f, 0.035f},
                                     {kRadius - 0.014f, 0.03f}, {kRadius - 0.014f, 0.02f}};
  Mesh& steel = piece.part(Finish::darkSteel);
  modelling::addLathe(steel, glm::vec3(0.0f), rim, 15);
  Mesh& face = piece.part(Finish::whiteLacquer);
  const std::array<glm::vec2, 2> dial{glm::vec2(kRadius - 0.013f, 0.021f), {0.0f, 0.021f}};
  modelling::addLathe(face, glm::vec3(0.0f), dial, 15);
  aimFrom(steel, 0, {0, 0, 1}, glm::vec3(0.0f));
  aimFrom(face, 0, {0, 0, 1}, glm::vec3(0.0f));
  const auto hand = [&](float degrees, glm::vec2 low, glm::vec2 high, float z) {
    const std::size_t first = steel.vertices.size();
    addBox(steel, {low.x, low.y, z}, {high.x, high.y, z + 0.002f});
    modelling::transformFrom(steel, first, turned(degrees, {0, 0, 1}));
  };
  for (int hour = 0; hour < 12; hour += 3) {
    constexpr float kWidth = 0.004f;
    hand(30.0f * static_cast<float>(hour), {-kWidth, 0.108f}, {kWidth, 0.126f}, 0.0205f);
  }
  hand(-305.0f, {-0.005f, -0.02f}, {0.005f, 0.075f}, 0.0235f);  // ten past ten
  hand(-62.0f, {-0.0035f, -0.025f}, {0.0035f, 0.112f}, 0.0265f);
  addRod(steel, {0, 0, 0.02f}, {0, 0, 0.03f}, 0.009f, 10);
  return piece;
}

Piece tileCeiling(const RoomSize& room, float tile) {
  Piece piece("tile ceiling");
  constexpr float kBar = 0.024f;   // visible width of a bar of the grid
  constexpr float kRise = 0.006f;  // the tiles lie on the bars' upper faces
  const int columns = static_cast<int>(std::ceil(room.width / tile));
  const int rows = static_cast<int>(std::ceil(room.depth / tile));
  const glm::vec2 size = glm::vec2(room.width, room.depth) / glm::vec2(columns, rows);
  const glm::vec2 corner = -0.5f * glm::vec2(room.width, room.depth);
  Mesh& tiles = piece.part(Finish::ceilingTile);
  Mesh& bars = piece.part(Finish::paintedSteel);
  const float half = 0.5f * kBar;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const glm::vec2 low = corner + size * glm::vec2(i, j);
      modelling::addQuad(tiles, {low.x, kRise, low.y}, {size.x, 0, 0}, {0, 0, size.y});
      if (j == 0) continue;
      addCeilingBar(bars, {low.x + (i > 0 ? half : 0.0f), 0.0f, low.y},
                    {low.x + size.x - (i + 1 < columns ? half : 0.0f), 0.0f, low.y}, {0.0f, kRise, half});
    }
    if (i == 0) continue;
    const float x = corner.x + size.x * static_cast<float>(i);
    addCeilingBar(bars, {x, 0.0f, -corner.y}, {x, 0.0f, corner.y}, {half, kRise, 0.0f});
  }
  return piece;
}

Piece framedPicture(glm::vec2 size, Finish frame) {
  Piece piece("framed picture");
  constexpr float kMount = 0.05f;
  const std::array<glm::vec2, 9> section{glm::vec2(0.0f, 0.0f), {0.045f, 0.0f},   {0.045f, 0.014f},
                                         {0.038f, 0.024f},      {0.03f, 0.026f},  {0.024f, 0.02f},
                                         {0.012f, 0.016f},      {0.006f, 0.018f}, {0.0f, 0.014f}};
  addFrame(piece.part(frame), size, section);
  const glm::vec2 h = size * 0.5f;
  modelling::addQuad(piece.part(Finish::whiteLacquer), {-h.x, -h.y, 0.007f}, {size.x, 0, 0}, {0, size.y, 0});
  const glm::vec2 inner = h - kMount;
  Mesh& canvas = piece.part(Finish::picture);
  addBox(canvas, {-inner.x, -inner.y, 0.0065f}, {inner.x, inner.y, 0.0085f});
  // One repeat of the painting fills the canvas.
  for (Vertex& vertex : canvas.vertices)
    vertex.uv =
        glm::vec2(0.5f + 0.5f * vertex.position.x / inner.x, 0.5f - 0.5f * vertex.position.y / inner.y) *
        glm::vec2(0.7f, 0.5f);
  return piece;
}

Piece socket() {
  Piece piece("socket");
  Mesh& plastic = piece.part(Finish::whiteLacquer);
  addBox(plastic, {-0.04f, -0.04f, -0.002f}, {0.04f, 0.04f, 0.009f});
  addRod(piece.part(Finish::greyPlastic), {0, 0, 0.006f}, {0, 0, 0.0095f}, 0.02f, 12);
  return piece;
}

}  // namespace host::furniture
