// The laid table of the breakfast room.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host {

/// Places everything that lies on a table of `size` that stands at `foot`.
void layBreakfast(furniture::Interior& room, glm::vec3 foot, glm::vec2 size);

}  // namespace host
