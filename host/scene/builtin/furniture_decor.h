// What makes a room a home: parquet, panelling, mouldings, rug.
#pragma once

#include "host/scene/builtin/furniture.h"
#include "host/scene/builtin/furniture_room.h"

namespace host::furniture {

/// Herringbone parquet of bevelled blocks with open joints; its upper face is at y = 0. The blocks run on
/// under the walls.
Piece herringboneParquet(const RoomSize& room, glm::vec2 block);

/// Skirting board profile and cornice profile, for addMoulding: (away from the wall, up), from the floor up
/// and from the ceiling down.
std::span<const glm::vec2> skirtingProfile();
std::span<const glm::vec2> corniceProfile();
std::span<const glm::vec2> chairRailProfile();

/// A thin boarding of a wall from the floor to `height` with `count` raised panels, about x = 0, before a
/// wall at z = 0.
Piece wainscot(float length, float height, int count);

/// A rectangular rug with a border, a pile that bulges over its edge, and a fringe of knotted strands at both
/// ends.
Piece rug(glm::vec2 size, std::uint32_t seed);

}  // namespace host::furniture
