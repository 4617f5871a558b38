// Books, binders and papers.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

/// A closed book standing on its lower edge with its spine at +Z, its left side at x = 0: size is (thickness,
/// height, depth). Boards overhang the pages.
Piece book(glm::vec3 size, Finish cover);

/// A row of different books from x = 0 to at most x = length, spines at z = front, some leaning on their
/// neighbours; `maxHeight` is what the shelf has room for.
struct BookRow {
  float length = 0.8f;
  float maxHeight = 0.32f;
  float front = 0.28f;
  std::uint32_t seed = 1;
};
Piece bookRow(const BookRow& row);

/// Lying books on each other, the largest below, their middles about the origin.
Piece bookStack(int count, std::uint32_t seed);

/// A box file of the office, standing, front at +Z.
Piece binder(Finish cover);

/// A storage box with a lid, front at +Z, its left side at x = 0.
Piece storageBox(Finish cover);

/// Sheets of A4 lying not quite on each other.
Piece paperStack(int sheets, std::uint32_t seed);

}  // namespace host::furniture
