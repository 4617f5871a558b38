#include "host/scene/builtin/furniture_room.h"

#include <algorithm>
#include <array>

#include "host/scene/builtin/furniture_shapes.h"

namespace host::furniture {

namespace {

using modelling::addQuad;

constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f};

// Where openings begin and end along one direction, cut into by the wall's own ends.
std::vector<float> cuts(std::span<const Opening> openings, int axis, float length) {
  std::vector<float> result{0.0f, length};
  for (const Opening& opening : openings) {
    const float begin = axis == 0 ? opening.left : opening.bottom;
    result.push_back(begin);
    result.push_back(begin + opening.size[axis]);
  }
  std::sort(result.begin(), result.end());
  const auto same = [](float a, float b) { return b - a < 1e-4f; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

// The wall as a grid whose lines run along all edges of openings.
class WallGrid {
 public:
  WallGrid(const Wall& wall, std::span<const Opening> openings)
      : wall_(wall),
        openings_(openings),
        x_(cuts(openings, 0, wall.length)),
        y_(cuts(openings, 1, wall.height)) {}

  [[nodiscard]] int columns() const { return static_cast<int>(x_.size()) - 1; }
  [[nodiscard]] int rows() const { return static_cast<int>(y_.size()) - 1; }

  [[nodiscard]] bool isSolid(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns() || row >= rows()) return true;
    const float x = 0.5f * (x_[column] + x_[column + 1]);
    const float y = 0.5f * (y_[row] + y_[row + 1]);
    return std::none_of(openings_.begin(), openings_.end(), [&](const Opening& o) {
      return x > o.left && x < o.left + o.size.x && y > o.bottom && y < o.bottom + o.size.y;
    });
  }

  [[nodiscard]] glm::vec3 inner(int column, int row) const {
    return wall_.start + wall_.along * x_[column] + kUp * y_[row];
  }

  [[nodiscard]] glm::vec3 outer(int column, int row) const {
    float x = x_[column];
    if (column == 0) x -= wall_.thickness;
    if (column == columns()) x += wall_.thickness;
    return wall_.start + wall_.along * x + kUp * y_[row] + outwards();
  }

  [[nodiscard]] glm::vec3 outwards() const { return glm::cross(wall_.along, kUp) * wall_.thickness; }

 private:
  Wall wall_;
  std::span<const Opening> openings_;
  std::vector<float> x_;
  std::vector<float> y_;
};

void addFaces(Piece& piece, const WallGrid& grid, int column, int row, Finish inside) {
  const glm::vec3 right = grid.inner(column + 1, row);
  addQuad(piece.part(inside), right, grid.inner(column, row) - right,
          grid.inner(column + 1, row + 1) - right);
  const glm::vec3 left = grid.outer(column, row);
  addQuad(piece.part(Finish::outsideWall), left, grid.outer(column + 1, row) - left,
          grid.outer(column, row + 1) - left);
}

// The sides of an open cell that touch solid wall.
void addReveals(Mesh& mesh, const WallGrid& grid, int column, int row) {
  const glm::vec3 out = grid.outwards();
  const glm::vec3 lowLeft = grid.inner(column, row);
  const glm::vec3 lowRight = grid.inner(column + 1, row);
  const glm::vec3 highLeft = grid.inner(column, row + 1);
  const glm::vec3 rise = highLeft - lowLeft;
  const glm::vec3 run = lowRight - lowLeft;
  if (grid.isSolid(column - 1, row)) addQuad(mesh, lowLeft, rise, out);
  if (grid.isSolid(column + 1, row)) addQuad(mesh, lowRight, out, rise);
  if (row > 0 && grid.isSolid(column, row - 1)) addQuad(mesh, lowLeft, out, run);
  if (grid.isSolid(column, row + 1)) addQuad(mesh, highLeft, run, out);
}

void addDoorPanels(Mesh& mesh, glm::vec2 size, float front) {
  constexpr float kStile = 0.11f;
  const std::array<glm::vec2, 7> moulding{
      glm::vec2(-0.03f, -0.004f), {0.0f, -0.004f},   {0.0f, 0.006f},  {-0.008f, 0.012f},
      {-0.016f, 0.01f},           {-0.022f, 0.004f}, {-0.03f, 0.003f}};
  const glm::vec2 panel((size.x - 3.0f * kStile) * 0.5f, 0.0f);
  const std::array<glm::vec2, 2> spans{glm::vec2(0.22f, 0.85f), {1.02f, size.y - 0.13f}};
  for (const glm::vec2 span : spans) {
    for (const float side : {-1.0f, 1.0f}) {
      const glm::vec2 frame(panel.x, span.y - span.x);
      const glm::vec3 centre(side * (panel.x + kStile) * 0.5f, (span.x + span.y) * 0.5f, front);
      const std::size_t first = mesh.vertices.size();
      addFrame(mesh, frame, moulding);
      modelling::transformFrom(mesh, first, at(centre));
      const glm::vec3 half(frame.x * 0.5f - 0.07f, frame.y * 0.5f - 0.07f, 0.006f);
      modelling::addBox(mesh, centre - half, centre + half, 0.005f);
    }
  }
}

void addLeverHandle(Mesh& mesh, glm::vec3 at) {
  modelling::addBox(mesh, at - glm::vec3(0.02f, 0.11f, 0.004f), at + glm::vec3(0.02f, 0.11f, 0.006f), 0.003f);
  const std::array<glm::vec3, 4> lever{at, at + glm::vec3(0, 0, 0.04f), at + glm::vec3(0.012f, 0, 0.052f),
                                       at + glm::vec3(0.12f, 0, 0.052f)};
  modelling::addSweep(mesh, modelling::circleOutline(0.009f, 10), lever);
}

}  // namespace

void addWall(Piece& piece, const Wall& wall, std::span<const Opening> openings, Finish inside) {
  const WallGrid grid(wall, openings);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      if (grid.isSolid(column, row)) {
        addFaces(piece, grid, column, row, inside);
      } else {
        addReveals(piece.part(inside), grid, column, row);
      }
    }
  }
}

Wall wallOf(const RoomSize& room, Side side) {
  const std::vector<glm::vec3> corners = roomCorners(room, 0.0f);
  const auto i = static_cast<std::size_t>(side);
  const glm::vec3 way = corners[(i + 1) % 4] - corners[i];
  return {corners[i], glm::normalize(way), glm::length(way), room.height, room.wallThickness};
}

std::vector<glm::vec3> roomCorners(const RoomSize& room, float height) {
  const float x = room.width * 0.5f;
  const float z = room.depth * 0.5f;
  return {{x, height, -z}, {-x, height, -z}, {-x, height, z}, {x, height, z}};
}

Opening openingAt(const Wall& wall, glm::vec3 middle, glm::vec2 size) {
  return {glm::dot(middle - wall.start, wall.along) - 0.5f * size.x, middle.y, size};
}

void addFloorAndCeiling(Piece& piece, const RoomSize& room, Finish floor, float floorLevel) {
  const float x = room.width * 0.5f + room.wallThickness;
  const float z = room.depth * 0.5f + room.wallThickness;
  modelling::addBox(piece.part(floor), {-x, -0.2f, -z}, {x, floorLevel, z});
  modelling::addBox(piece.part(Finish::ceilingPaint), {-x, room.height, -z}, {x, room.height + 0.2f, z});
}

Piece closedDoor(glm::vec2 size, DoorLeaf leaf, Finish wood) {
  constexpr float kThickness = 0.04f;
  constexpr float kGap = 0.004f;
  constexpr float kFront = -0.02f;  // the leaf lies back from the casing
  Piece door("door");
  const glm::vec3 half(size.x * 0.5f - kGap, 0.0f, 0.0f);
  modelling::addBox(door.part(wood), glm::vec3(0, kGap, kFront - kThickness) - half,
                    glm::vec3(0, size.y - kGap, kFront) + half, 0.003f);
  if (leaf == DoorLeaf::panelled) addDoorPanels(door.part(wood), size, kFront);
  addLeverHandle(door.part(Finish::brass), {-size.x * 0.5f + 0.07f, 1.02f, kFront});

  // The casing runs up one side, over the top and down the other.
  const float x = size.x * 0.5f;
  const std::array<glm::vec3, 4> path{glm::vec3(x, 0, 0), {x, size.y, 0}, {-x, size.y, 0}, {-x, 0, 0}};
  const std::array<glm::vec2, 8> section{glm::vec2(0.0f, -0.14f), {0.012f, -0.14f}, {0.012f, -0.01f},
                                         {0.09f, -0.01f},         {0.09f, 0.022f},  {0.075f, 0.026f},
                                         {0.02f, 0.016f},         {0.0f, 0.014f}};
  modelling::addSweep(door.part(Finish::trimPaint), section, path, false, 40.0f, {0.0f, 0.0f, 1.0f});
  return door;
}

}  // namespace host::furniture
