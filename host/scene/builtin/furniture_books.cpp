#include "host/scene/builtin/furniture_books.h"

#include <array>
#include <cmath>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addBox;

constexpr std::array<Finish, 6> kCovers{Finish::coverRed,   Finish::coverBlue,  Finish::coverGreen,
                                        Finish::coverCream, Finish::coverBlack, Finish::coverOchre};

glm::vec3 randomBookSize(Random& random, float maxHeight) {
  const float height = random.between(0.62f, 0.96f) * maxHeight;
  return {random.between(0.018f, 0.06f), height, std::min(height * random.between(0.66f, 0.76f), 0.23f)};
}

}  // namespace

Piece book(glm::vec3 size, Finish cover) {
  Piece piece("book");
  constexpr float kBoard = 0.0025f;
  constexpr float kOverhang = 0.004f;
  // The case seen from above: one board, the spine, the other board.
  const float t = size.x;
  const float back = -size.z;
  const std::array<glm::vec2, 8> outline{
      glm::vec2(0.0f, back), {kBoard, back}, {kBoard, -kBoard}, {t - kBoard, -kBoard},
      {t - kBoard, back},    {t, back},      {t, 0.0f},         {0.0f, 0.0f}};
  Mesh& boards = piece.part(cover);
  addPrism(boards, outline, 0.0f, size.y);
  // Only the upper and the fore edges of the pages ever show.
  const glm::vec3 width(t - 2.0f * kBoard, 0.0f, 0.0f);
  const glm::vec3 fore(kBoard, size.y - kOverhang, back + kOverhang);
  Mesh& pages = piece.part(Finish::pages);
  modelling::addQuad(pages, {kBoard, fore.y, -kBoard}, width, {0.0f, 0.0f, fore.z + kBoard});
  modelling::addQuad(pages, {kBoard, 0.0f, fore.z}, {0.0f, fore.y, 0.0f}, width);
  return piece;
}

Piece bookRow(const BookRow& row) {
  Piece piece("row of books");
  Random random(row.seed);
  float x = 0.0f;
  int uprightBefore = 0;
  while (true) {
    const glm::vec3 size = randomBookSize(random, row.maxHeight);
    const Finish cover = kCovers[random.index(static_cast<int>(kCovers.size()))];
    const float inset = random.between(0.0f, 0.012f);
    // After a few upright books one leans back against them: turned about its lower far edge, its upper left
    // edge touches the neighbour.
    const bool leans = uprightBefore >= 4 && random.between(0.0f, 1.0f) < 0.22f;
    const float degrees = leans ? random.between(6.0f, 13.0f) : 0.0f;
    const float angle = glm::radians(degrees);
    const float shift = size.y * std::sin(angle);
    const float footprint = shift + size.x * std::cos(angle);
    if (x + footprint > row.length) break;
    // Leaning to the left, the book stands on its lower left edge at x + shift.
    const glm::mat4 lean = at({x + shift, 0.0f, row.front - inset}) * turned(degrees, {0, 0, 1});
    piece.add(book(size, cover), lean);
    x += footprint + 0.0008f;
    uprightBefore = leans ? 0 : uprightBefore + 1;
  }
  return piece;
}

Piece bookStack(int count, std::uint32_t seed) {
  Piece piece("stack of books");
  Random random(seed);
  float y = 0.0f;
  for (int i = 0; i < count; ++i) {
    const float shrink = 1.0f - 0.08f * static_cast<float>(i);
    const glm::vec3 size(random.between(0.018f, 0.036f), 0.25f * shrink, 0.18f * shrink);
    const Finish cover = kCovers[random.index(static_cast<int>(kCovers.size()))];
    // Lying on its front board: the thickness points up.
    const glm::mat4 lying = at({0.0f, y, 0.0f}, random.between(-12.0f, 12.0f)) *
                            at({0.5f * size.y, 0.0f, 0.5f * size.z}) * turned(90.0f, {0, 0, 1});
    piece.add(book(size, cover), lying);
    y += size.x + 0.0003f;
  }
  return piece;
}

Piece binder(Finish cover) {
  Piece piece("binder");
  constexpr glm::vec3 kSize{0.075f, 0.315f, 0.285f};
  addBox(piece.part(cover), {0.0f, 0.0f, -kSize.z}, {kSize.x, kSize.y, 0.0f});
  addBox(piece.part(Finish::pages), {0.012f, 0.15f, -0.002f}, {kSize.x - 0.012f, 0.27f, 0.001f});
  return piece;
}

Piece storageBox(Finish cover) {
  Piece piece("storage box");
  constexpr glm::vec3 kSize{0.26f, 0.21f, 0.27f};
  constexpr float kLid = 0.05f;
  addBox(piece.part(cover), {0.003f, 0.0f, -kSize.z + 0.003f}, {kSize.x - 0.003f, kSize.y - kLid, -0.003f});
  addBox(piece.part(cover), {0.0f, kSize.y - kLid, -kSize.z}, {kSize.x, kSize.y, 0.0f});
  addBox(piece.part(Finish::pages), {0.09f, 0.06f, -0.004f}, {0.17f, 0.11f, -0.002f});
  return piece;
}

Piece paperStack(int sheets, std::uint32_t seed) {
  Piece piece("papers");
  Random random(seed);
  constexpr float kThickness = 0.0012f;
  for (int i = 0; i < sheets; ++i) {
    Mesh sheet;
    addBlock(sheet, glm::vec3(0.0f), {0.21f, kThickness, 0.297f});
    // The print starts at the sheet's upper left corner.
    for (Vertex& vertex : sheet.vertices)
      vertex.uv = {vertex.position.x + 0.105f, vertex.position.z + 0.1485f};
    const glm::vec3 place(random.between(-0.008f, 0.008f), kThickness * 1.05f * static_cast<float>(i),
                          random.between(-0.008f, 0.008f));
    modelling::addMesh(piece.part(Finish::paper), sheet, at(place, random.between(-7.0f, 7.0f)));
  }
  return piece;
}

}  // namespace host::furniture
