// Chairs and benches. The sitter looks towards +Z.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

/// Turned front legs, raked back posts, a bowed top rail over slats, stretchers, an upholstered seat.
Piece slatBackChair();

/// A long bench on turned legs with a seat cushion; its middle is the origin.
Piece bench(float width);

/// Five-star base on twin casters, gas spring, upholstered seat and back, armrests.
Piece officeChair();

}  // namespace host::furniture
