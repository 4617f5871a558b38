#include "host/scene/builtin/furniture_tables.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addBox;

void addTableLeg(Mesh& mesh, glm::vec3 foot) {
  constexpr float kBlock = 0.58f;  // below it the leg is turned, above it stays square for the apron
  const std::array<glm::vec2, 30> profile{
      glm::vec2(0.0f, 0.0f), {0.018f, 0.0f},    {0.026f, 0.01f},  {0.03f, 0.026f},  {0.026f, 0.042f},
      {0.018f, 0.052f},      {0.016f, 0.066f},  {0.022f, 0.076f}, {0.024f, 0.084f}, {0.02f, 0.093f},
      {0.019f, 0.11f},       {0.023f, 0.18f},   {0.03f, 0.28f},   {0.036f, 0.36f},  {0.0385f, 0.41f},
      {0.037f, 0.445f},      {0.031f, 0.472f},  {0.023f, 0.487f}, {0.021f, 0.492f}, {0.033f, 0.497f},
      {0.036f, 0.506f},      {0.033f, 0.515f},  {0.024f, 0.52f},  {0.021f, 0.53f},  {0.023f, 0.54f},
      {0.031f, 0.546f},      {0.0345f, 0.556f}, {0.031f, 0.566f}, {0.026f, 0.572f}, {0.024f, kBlock}};
  modelling::addLathe(mesh, foot, profile, 28);
  const std::size_t first = mesh.vertices.size();
  addBox(mesh, foot + glm::vec3(-0.04f, kBlock, -0.04f), foot + glm::vec3(0.04f, kTableHeight - 0.03f, 0.04f),
         0.004f);
  modelling::turnTextureFrom(mesh, first);
}

// A box with its grain along +Y.
void addUpright(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
  const std::size_t first = mesh.vertices.size();
  addBox(mesh, low, high);
  modelling::turnTextureFrom(mesh, first);
}

void addKnob(Mesh& mesh, glm::vec3 at) {
  const std::array<glm::vec2, 8> profile{glm::vec2(0.0f, -0.002f), {0.009f, -0.002f}, {0.007f, 0.004f},
                                         {0.006f, 0.012f},         {0.012f, 0.018f},  {0.0145f, 0.024f},
                                         {0.011f, 0.03f},          {0.0f, 0.032f}};
  const std::size_t first = mesh.vertices.size();
  modelling::addLathe(mesh, glm::vec3(0.0f), profile, 20);
  aimFrom(mesh, first, {0, 0, 1}, at);
}

// A drawer front or door: a bevelled slab with a raised moulding.
void addFront(Mesh& wood, glm::vec2 low, glm::vec2 high, float z) {
  addBox(wood, {low.x, low.y, z - 0.004f}, {high.x, high.y, z + 0.018f}, 0.004f);
  const std::array<glm::vec2, 6> section{glm::vec2(-0.016f, -0.003f), {0.0f, -0.003f},  {0.0f, 0.004f},
                                         {-0.004f, 0.008f},           {-0.01f, 0.007f}, {-0.016f, 0.002f}};
  const std::size_t first = wood.vertices.size();
  addFrame(wood, high - low - 0.07f, section);
  modelling::transformFrom(wood, first, at(glm::vec3(0.5f * (low + high), z + 0.018f)));
}

}  // namespace

Piece diningTable(glm::vec2 size) {
  Piece table("dining table");
  Mesh& wood = table.part(Finish::walnut);
  addTableTop(wood, size, 0.06f, kTableHeight - 0.03f, kTableHeight, 8);
  const glm::vec2 leg = size * 0.5f - 0.11f;
  constexpr float kLow = 0.625f;
  constexpr float kHigh = kTableHeight - 0.03f;
  for (const float x : {-leg.x, leg.x}) {
    for (const float z : {-leg.y, leg.y}) addTableLeg(wood, {x, 0.0f, z});
    addBox(wood, {x - 0.012f, kLow, -leg.y + 0.04f}, {x + 0.012f, kHigh, leg.y - 0.04f});
  }
  for (const float z : {-leg.y, leg.y})
    addBox(wood, {-leg.x + 0.04f, kLow, z - 0.012f}, {leg.x - 0.04f, kHigh, z + 0.012f});
  return table;
}

Piece tableRunner(glm::vec2 tableSize, float width) {
  Piece piece("table runner");
  constexpr float kLift = 0.0015f;
  constexpr float kDrop = 0.24f;
  const float half = tableSize.x * 0.5f;
  const float bend = 0.02f;
  // Arc length along the runner: flat, over the edge in a quarter circle, down with gathering folds.
  const auto cloth = [&](float u, float v) {
    const float flat = half - 0.008f;
    const float arc = bend * glm::half_pi<float>();
    const float total = flat + arc + kDrop;
    const float s = std::abs(2.0f * u - 1.0f) * total;
    const float side = u < 0.5f ? -1.0f : 1.0f;
    const float z = (0.5f - v) * width;
    if (s <= flat) return glm::vec3(side * s, kTableHeight + kLift, z);
    const float around = std::min((s - flat) / bend, glm::half_pi<float>());
    const float down = std::max(s - flat - arc, 0.0f);
    const float fold = 0.022f * down / kDrop * (std::sin(z * 30.0f + side) + 1.0f);
    return glm::vec3(side * (flat + bend * std::sin(around) + fold),
                     kTableHeight + kLift - bend * (1.0f - std::cos(around)) - down, z);
  };
  modelling::addPatch(piece.part(Finish::runner), cloth, {128, 28});
  return piece;
}

Piece desk(glm::vec2 size, float pedestalSide) {
  Piece piece("desk");
  const glm::vec2 half = size * 0.5f;
  constexpr float kTop = 0.028f;
  constexpr float kUnder = kDeskHeight - kTop;
  addBox(piece.part(Finish::beech), {-half.x, kUnder, -half.y}, {half.x, kDeskHeight, half.y}, 0.004f);

  Mesh& steel = piece.part(Finish::paintedSteel);
  const float legX = -pedestalSide * (half.x - 0.06f);
  for (const float z : {-half.y + 0.06f, half.y - 0.06f})
    addBox(steel, {legX - 0.02f, 0.0f, z - 0.02f}, {legX + 0.02f, kUnder, z + 0.02f});
  addBox(steel, {legX - 0.015f, kUnder - 0.05f, -half.y + 0.08f}, {legX + 0.015f, kUnder, half.y - 0.08f});
  addBox(piece.part(Finish::beech), {-half.x + 0.08f, 0.32f, -half.y + 0.05f},
         {half.x - 0.08f, kUnder, -half.y + 0.068f});

  // The pedestal carries the other end of the top.
  const float inner = pedestalSide * (half.x - 0.44f);
  const float outer = pedestalSide * (half.x - 0.02f);
  const glm::vec2 x(std::min(inner, outer), std::max(inner, outer));
  Mesh& lacquer = piece.part(Finish::whiteLacquer);
  const float front = half.y - 0.06f;
  addBox(lacquer, {x.x, 0.04f, -half.y + 0.07f}, {x.y, kUnder, front});
  addBox(piece.part(Finish::darkSteel), {x.x + 0.02f, 0.0f, -half.y + 0.09f},
         {x.y - 0.02f, 0.04f, front - 0.03f});
  const std::array<float, 4> gaps{0.045f, 0.325f, 0.515f, kUnder - 0.004f};
  for (int drawer = 0; drawer < 3; ++drawer) {
    addBox(lacquer, {x.x + 0.002f, gaps[drawer] + 0.002f, front - 0.002f},
           {x.y - 0.002f, gaps[drawer + 1] - 0.002f, front + 0.018f});
    const float y = gaps[drawer + 1] - 0.045f;
    const float middle = 0.5f * (x.x + x.y);
    const std::array<glm::vec3, 4> pull{glm::vec3(middle - 0.06f, y, front + 0.016f),
                                        {middle - 0.06f, y, front + 0.044f},
                                        {middle + 0.06f, y, front + 0.044f},
                                        {middle + 0.06f, y, front + 0.016f}};
    modelling::addSweep(piece.part(Finish::chrome), modelling::rectangleOutline(0.008f, 0.008f), pull);
  }
  return piece;
}

Piece sideboard(float width, float depth) {
  Piece piece("sideboard");
  Mesh& wood = piece.part(Finish::oak);
  const float half = width * 0.5f;
  constexpr float kBottom = 0.13f;
  constexpr float kUnder = kSideboardHeight - 0.03f;
  const std::array<glm::vec2, 9> foot{glm::vec2(0.0f, 0.0f), {0.014f, 0.0f},   {0.02f, 0.01f},
                                      {0.018f, 0.03f},       {0.024f, 0.06f},  {0.032f, 0.09f},
                                      {0.026f, 0.105f},      {0.034f, 0.115f}, {0.034f, kBottom}};
  for (const float x : {-half + 0.06f, half - 0.06f}) {
    for (const float z : {0.07f, depth - 0.06f}) modelling::addLathe(wood, {x, 0.0f, z}, foot, 20);
  }
  addBox(wood, {-half, kBottom, 0.005f}, {half, kUnder, depth - 0.02f}, 0.004f);
  const std::size_t first = wood.vertices.size();
  addTableTop(wood, {width + 0.05f, depth + 0.005f}, 0.02f, kUnder, kSideboardHeight, 5);
  modelling::transformFrom(wood, first, at({0.0f, 0.0f, 0.5f * depth + 0.004f}));

  constexpr int kColumns = 4;
  const float step = (width - 0.04f) / kColumns;
  for (int i = 0; i < kColumns; ++i) {
    const float left = -half + 0.02f + step * static_cast<float>(i) + 0.006f;
    const float right = left + step - 0.012f;
    const float middle = 0.5f * (left + right);
    const float z = depth - 0.02f;
    addFront(wood, {left, 0.655f}, {right, kUnder - 0.015f}, z);
    addFront(wood, {left, kBottom + 0.02f}, {right, 0.643f}, z);
    Mesh& metal = piece.part(Finish::brass);
    addKnob(metal, {middle, 0.735f, z + 0.018f});
    addKnob(metal, {i % 2 == 0 ? right - 0.025f : left + 0.025f, 0.45f, z + 0.018f});
  }
  return piece;
}

float shelfHeight(const ShelfShape& shape, int shelf) {
  constexpr float kPlinth = 0.06f;
  const float pitch = (shape.size.y - kPlinth - kShelfBoard) / static_cast<float>(shape.shelves);
  return kPlinth + kShelfBoard + pitch * static_cast<float>(shelf);
}

Piece shelfUnit(const ShelfShape& shape) {
  Piece piece("shelf unit");
  Mesh& wood = piece.part(Finish::beech);
  const float half = shape.size.x * 0.5f;
  const float depth = shape.size.z;
  for (const float side : {-1.0f, 1.0f}) {
    const float x = side * (half - 0.5f * kShelfBoard);
    addUpright(wood, {x - 0.5f * kShelfBoard, 0.0f, 0.0f}, {x + 0.5f * kShelfBoard, shape.size.y, depth});
  }
  const float inside = half - kShelfBoard;
  for (int shelf = 0; shelf <= shape.shelves; ++shelf) {
    const float top = shelfHeight(shape, shelf) - (shelf == shape.shelves ? 0.001f : 0.0f);
    addBox(wood, {-inside, top - kShelfBoard, 0.008f}, {inside, top, depth - 0.003f});
  }
  addBox(wood, {-inside, 0.0f, depth - 0.05f}, {inside, shelfHeight(shape, 0) - kShelfBoard, depth - 0.035f});
  addBox(piece.part(Finish::whiteLacquer), {-inside, 0.0f, 0.002f}, {inside, shape.size.y - 0.004f, 0.008f});
  return piece;
}

}  // namespace host::furniture
