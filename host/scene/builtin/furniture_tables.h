// Tables, desks and cupboards. The user of a desk sits at +Z of it; a cupboard's front is +Z, its back is z =
// 0.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

/// A wooden table with turned legs; its top is at kTableHeight.
constexpr float kTableHeight = 0.75f;
Piece diningTable(glm::vec2 size);

/// A cloth runner over the middle of a table of `tableSize`, hanging down at both ends.
Piece tableRunner(glm::vec2 tableSize, float width);

/// A desk with steel legs, a modesty panel, and a pedestal of three drawers at one side (+1 right, -1 left,
/// as seen by the user); its top is at kDeskHeight.
constexpr float kDeskHeight = 0.73f;
Piece desk(glm::vec2 size, float pedestalSide);

/// Drawers above, doors below, on short turned feet; its top is at kSideboardHeight.
constexpr float kSideboardHeight = 0.86f;
Piece sideboard(float width, float depth);

/// An open shelf unit: `shelves` boards between floor and top. Its boards' upper faces are at shelfHeight().
struct ShelfShape {
  glm::vec3 size{0.9f, 2.0f, 0.3f};
  int shelves = 5;
};
constexpr float kShelfBoard = 0.022f;
float shelfHeight(const ShelfShape& shape, int shelf);
Piece shelfUnit(const ShelfShape& shape);

}  // namespace host::furniture
