// The shell of a room and what is fixed to it.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

/// A rectangular hole in a wall; `left` is measured along the wall from its start.
struct Opening {
  float left = 0.0f;
  float bottom = 0.0f;
  glm::vec2 size{1.0f};
};

/// The inside of a rectangular room, centred on the origin, floor at y = 0.
struct RoomSize {
  float width = 0.0f;  ///< along x
  float depth = 0.0f;  ///< along z
  float height = 0.0f;
  float wallThickness = 0.3f;
};

/// One wall from `start`, `length` metres along `along`; the room is to the left of that way, seen from
/// above. Its outer face is longer by the thickness at both ends, so that the walls of a room meet in mitres.
struct Wall {
  glm::vec3 start{0.0f};
  glm::vec3 along{1.0f, 0.0f, 0.0f};
  float length = 1.0f;
  float height = 1.0f;
  float thickness = 0.3f;
};

/// Inner and outer faces in their finishes and the reveals of the openings; no T-junctions, no faces on the
/// floor.
void addWall(Piece& piece, const Wall& wall, std::span<const Opening> openings, Finish inside);

/// The wall to the north (-Z), west (-X), south (+Z) or east (+X) of a room.
enum class Side { north, west, south, east };
Wall wallOf(const RoomSize& room, Side side);

/// Floor points of the room's corners, counter-clockwise from above, starting at the north-east; the path
/// that joined mouldings take.
std::vector<glm::vec3> roomCorners(const RoomSize& room, float height);

/// The opening of `size` in `wall` whose lower edge has its middle at `middle`.
Opening openingAt(const Wall& wall, glm::vec3 middle, glm::vec2 size);

/// A floor slab whose upper face is at `floorLevel` and a ceiling slab above the room, under and over its
/// walls.
void addFloorAndCeiling(Piece& piece, const RoomSize& room, Finish floor, float floorLevel);

/// A closed door of `size` with its casing and handle in the plane z = 0, facing +Z.
enum class DoorLeaf { flush, panelled };
Piece closedDoor(glm::vec2 size, DoorLeaf leaf, Finish wood);

}  // namespace host::furniture
