// What is fixed to walls and ceilings of an office, and what stands about in it.
#pragma once

#include "host/scene/builtin/furniture.h"
#include "host/scene/builtin/furniture_room.h"

namespace host::furniture {

/// A panel radiator with pipes and valve, before a wall at z = 0, standing clear of the floor.
Piece radiator(float width, float height);

/// A tapered bin with crumpled paper in it.
Piece wasteBasket();

/// A framed pin board in the plane z = 0 with notes on pins; its middle is the origin.
Piece pinBoard(glm::vec2 size, std::uint32_t seed);

/// A wall clock, facing +Z, its back at z = 0.
Piece wallClock();

/// A suspended ceiling: square tiles that lie in a grid of bars below the slab; its lower face is at y = 0.
Piece tileCeiling(const RoomSize& room, float tile);

/// A framed picture, facing +Z, its back at z = 0; the middle is the origin.
Piece framedPicture(glm::vec2 size, Finish frame);

/// A flat electric socket, its back at z = 0.
Piece socket();

}  // namespace host::furniture
