#include "host/scene/builtin/furniture_decor.h"

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

constexpr float kBevel = 0.0016f;
constexpr float kJointDepth = 0.0003f;  // flat bevels: steep ones would only flicker from afar

// The upper face of one block and its four bevels down into the joints, lying along +X with a corner at the
// origin.
Mesh blockMesh(glm::vec2 size) {
  Mesh mesh;
  const glm::vec2 in = size - 2.0f * kBevel;
  modelling::addQuad(mesh, {kBevel, 0.0f, size.y - kBevel}, {in.x, 0, 0}, {0, 0, -in.y});
  const std::array<glm::vec2, 4> low{glm::vec2(0, size.y), size, {size.x, 0}, {0, 0}};
  const std::array<glm::vec2, 4> high{
      glm::vec2(kBevel, size.y - kBevel), size - kBevel, {size.x - kBevel, kBevel}, {kBevel, kBevel}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const auto bevel = [&](float u, float v) {
      const glm::vec2 xz = glm::mix(glm::mix(low[i], low[next], u), glm::mix(high[i], high[next], u), v);
      return glm::vec3(xz.x, -kJointDepth * (1.0f - v), xz.y);
    };
    modelling::addPatch(mesh, bevel, {1, 1});
  }
  return mesh;
}

bool reaches(const RoomSize& room, const Mesh& mesh, const glm::mat4& transform) {
  glm::vec2 low(1e9f);
  glm::vec2 high(-1e9f);
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec4 p = transform * glm::vec4(vertex.position, 1.0f);
    low = glm::min(low, glm::vec2(p.x, p.z));
    high = glm::max(high, glm::vec2(p.x, p.z));
  }
  const glm::vec2 half = 0.5f * glm::vec2(room.width, room.depth);
  return high.x > -half.x && low.x < half.x && high.y > -half.y && low.y < half.y;
}

}  // namespace

Piece herringboneParquet(const RoomSize& room, glm::vec2 block) {
  Piece floor("parquet");
  Random random(5);
  const std::array<Finish, 3> shades{Finish::parquetLight, Finish::parquetMedium, Finish::parquetDark};
  const Mesh mesh = blockMesh(block);
  const auto ratio = static_cast<int>(std::lround(block.x / block.y));
  const int reach = static_cast<int>(std::ceil((room.width + room.depth) / block.y));
  // In units of the block's width, a herringbone repeats along (1, 1) and (ratio, -ratio); each repeat has a
  // block that lies along x and one that lies across, at its end. The pattern is turned by 45 degrees so that
  // its zigzags run along the room.
  const glm::mat4 diagonal = turned(45.0f, {0, 1, 0});
  const int rows = reach / (2 * ratio) + 2;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -rows; j <= rows; ++j) {
      const glm::vec2 corner = block.y * (glm::vec2(static_cast<float>(i)) +
                                          static_cast<float>(j * ratio) * glm::vec2(1.0f, -1.0f));
      const glm::mat4 lying = diagonal * at({corner.x, 0.0f, corner.y});
      const glm::mat4 across = diagonal * at({corner.x + block.x, 0.0f, corner.y + block.y}) *
                               turned(-90.0f, {0, 1, 0}) * at({-block.x, 0.0f, -block.y});
      for (const glm::mat4& place : {lying, across}) {
        if (!reaches(room, mesh, place)) continue;
        Mesh copy = mesh;
        const glm::vec2 grain(random.between(0.0f, 4.0f), random.between(0.0f, 4.0f));
        for (Vertex& vertex : copy.vertices) vertex.uv += grain;
        modelling::addMesh(floor.part(shades[random.index(3)]), copy, place);
      }
    }
  }
  return floor;
}

std::span<const glm::vec2> skirtingProfile() {
  static constexpr std::array<glm::vec2, 9> kProfile{
      glm::vec2(0.018f, -0.004f), {0.018f, 0.1f},   {0.022f, 0.104f},
      {0.022f, 0.112f},           {0.017f, 0.118f}, {0.012f, 0.13f},
      {0.011f, 0.142f},           {0.007f, 0.148f}, {0.0f, 0.15f}};
  return kProfile;
}

std::span<const glm::vec2> corniceProfile() {
  static constexpr std::array<glm::vec2, 16> kProfile{
      glm::vec2(0.0f, -0.14f), {0.014f, -0.138f}, {0.016f, -0.128f}, {0.012f, -0.12f},
      {0.014f, -0.112f},       {0.022f, -0.1f},   {0.036f, -0.082f}, {0.054f, -0.062f},
      {0.074f, -0.046f},       {0.088f, -0.04f},  {0.094f, -0.034f}, {0.094f, -0.026f},
      {0.104f, -0.024f},       {0.113f, -0.016f}, {0.116f, -0.006f}, {0.116f, 0.004f}};
  return kProfile;
}

std::span<const glm::vec2> chairRailProfile() {
  static constexpr std::array<glm::vec2, 10> kProfile{
      glm::vec2(0.0f, -0.035f), {0.01f, -0.034f}, {0.013f, -0.026f}, {0.012f, -0.016f}, {0.02f, -0.008f},
      {0.028f, 0.0f},           {0.031f, 0.008f}, {0.029f, 0.015f},  {0.022f, 0.019f},  {0.0f, 0.021f}};
  return kProfile;
}

Piece wainscot(float length, float height, int count) {
  Piece piece("wainscot");
  Mesh& paint = piece.part(Finish::trimPaint);
  constexpr float kBoard = 0.008f;
  constexpr float kStile = 0.1f;
  modelling::addBox(paint, {-0.5f * length, -0.002f, -0.002f}, {0.5f * length, height, kBoard});
  const glm::vec2 span(0.23f, height - 0.09f);
  const float width = (length - kStile * static_cast<float>(count + 1)) / static_cast<float>(count);
  const glm::vec2 field(width, span.y - span.x);
  const std::array<glm::vec2, 8> section{glm::vec2(-0.03f, -0.006f), {0.0f, -0.006f},   {0.0f, 0.008f},
                                         {-0.006f, 0.014f},          {-0.013f, 0.014f}, {-0.019f, 0.008f},
                                         {-0.026f, 0.006f},          {-0.03f, 0.002f}};
  for (int i = 0; i < count; ++i) {
    const float x = kStile + (width + kStile) * static_cast<float>(i) + 0.5f * width - 0.5f * length;
    const glm::vec3 middle(x, 0.5f * (span.x + span.y), kBoard);
    const std::size_t first = paint.vertices.size();
    addFrame(paint, field, section);
    modelling::transformFrom(paint, first, at(middle));
    const glm::vec3 half(0.5f * field - 0.06f, 0.007f);
    modelling::addBox(paint, middle - half, middle + half, 0.006f);
  }
  return piece;
}

Piece rug(glm::vec2 size, std::uint32_t seed) {
  Piece piece("rug");
  constexpr float kPile = 0.011f;
  constexpr float kBorder = 0.14f;
  const glm::vec2 inner = size - 2.0f * kBorder;
  addTableTop(piece.part(Finish::rugBorder), size, 0.012f, 0.0f, kPile - 0.001f, 3);
  // The field stands a little higher than the border; its repeats fit its size.
  Mesh& field = piece.part(Finish::rug);
  modelling::addBox(field, {-0.5f * inner.x, 0.002f, -0.5f * inner.y},
                    {0.5f * inner.x, kPile, 0.5f * inner.y}, 0.0008f);
  const glm::vec2 repeats = glm::round(inner / 0.5f);
  for (Vertex& vertex : field.vertices)
    vertex.uv = (glm::vec2(vertex.position.x, vertex.position.z) / inner + 0.5f) * repeats * 0.5f;

  Random random(seed);
  constexpr int kStrands = 120;
  Mesh& cords = piece.part(Finish::fringe);
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i < kStrands; ++i) {
      const float z = ((static_cast<float>(i) + 0.5f) / kStrands - 0.5f) * (size.y - 0.02f);
      const float x = side * 0.5f * size.x;
      const float drift = random.between(-0.012f, 0.012f);
      const float length = random.between(0.06f, 0.075f);
      const std::array<TubePoint, 4> strand{TubePoint{{x - side * 0.006f, 0.006f, z}, 0.0026f},
                                            {{x + side * 0.014f, 0.0052f, z}, 0.0036f},
                                            {{x + side * 0.024f, 0.003f, z + 0.3f * drift}, 0.0024f},
                                            {{x + side * length, 0.0024f, z + drift}, 0.0006f}};
      addTube(cords, strand, {5, 4});
    }
  }
  return piece;
}

}  // namespace host::furniture
