// Texture patterns that only furnished rooms need.
#pragma once

#include "host/scene/builtin/procedural_textures.h"

namespace host::furniture {

/// Mottling between two colours, `cells` spots a repeat, bumpy by `relief`.
textures::Pattern mottled(glm::vec3 a, glm::vec3 b, int cells, float relief, std::uint32_t seed);

/// Mineral-fibre ceiling tile: white with fine pin holes and worm-holes.
textures::Pattern acousticTile();

/// A woven rug's field: diamonds with stepped outlines in three colours on `ground`.
textures::Pattern rugField(glm::vec3 ground);

/// A page: lines of words, a heading and margins; one repeat is one sheet of A4, portrait.
textures::Pattern printedPage();

/// A monitor's picture: a window with a side bar and lines of code; one repeat is 16:10.
textures::Pattern screenPicture();

/// A painted landscape: sky, hills, a lake.
textures::Pattern landscape();

}  // namespace host::furniture
