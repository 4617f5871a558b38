// What lies and stands on desks. Everything rests on y = 0 and faces its user at +Z.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

Piece monitor();
Piece keyboard();
Piece mouse();        ///< with its cable running away to -Z
Piece letterTrays();  ///< three, with papers
Piece penCup();
Piece telephone();
Piece laptop();

/// Hanging cable from `from` to `to`, sagging by `sag` metres in its middle.
Piece cable(glm::vec3 from, glm::vec3 to, float sag);

}  // namespace host::furniture
