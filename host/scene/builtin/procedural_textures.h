// Textures made by code. A Pattern gives the surface's colour and relief over one repeat; it is drawn into a
// base colour image, and its relief into a normal map. The same on every machine: all randomness is integer
// hashing.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "host/scene/scene.h"

namespace host::textures {

/// Smooth noise in 0..1 over integer lattice cells; repeats after `period` cells.
float valueNoise(glm::vec2 at, glm::ivec2 period, std::uint32_t seed);

/// Octaves of valueNoise, each half as strong and twice as fine as the one before; in 0..1.
float fractalNoise(glm::vec2 at, glm::ivec2 period, int octaves, std::uint32_t seed);

/// A random number in 0..1 that belongs to an integer cell.
float cellNoise(glm::ivec2 cell, std::uint32_t seed);

struct Surface {
  glm::vec3 color{0.5f};  ///< sRGB, 0..1
  float height = 0.0f;    ///< as a fraction of the repeat's size
};

/// The surface at uv in 0..1 (v down), which repeats seamlessly.
using Pattern = std::function<Surface(glm::vec2 uv)>;

/// Grain along u, in `planks` boards side by side along v, each with its own shade.
Pattern wood(glm::vec3 light, glm::vec3 dark, int planks, std::uint32_t seed);

/// Clouded stone with veins; `veins` from 0 (clouds only) to 1.
Pattern marble(glm::vec3 base, glm::vec3 vein, float veins, std::uint32_t seed);

/// Trowelled plaster or dressed stone: faint mottling in colour and height.
Pattern plaster(glm::vec3 color, float contrast, std::uint32_t seed);

/// Plain weave of `threads` warp and weft threads, with a slight variation thread by thread.
Pattern fabric(glm::vec3 warp, glm::vec3 weft, int threads, std::uint32_t seed);

/// Blocks in running bond, with recessed joints.
struct Masonry {
  glm::ivec2 blocks{4, 8};      ///< columns and rows in a repeat; running bond needs an even number of rows
  float joint = 0.01f;          ///< width as a fraction of the repeat
  float stagger = 0.5f;         ///< shift of every second row, in blocks
  float shadeVariation = 0.1f;  ///< of the blocks, 0..1
  glm::vec3 jointColor{0.6f};   ///< sRGB
};
Pattern masonry(const Masonry& masonry, Pattern block, std::uint32_t seed);

/// A checkerboard of `cells` x `cells` (even) tiles of two patterns, with thin joints.
Pattern checker(int cells, Pattern even, Pattern odd, glm::vec3 jointColor);

/// The pattern's colour, size x size pixels.
Image baseColorImage(std::string name, int size, const Pattern& pattern);

/// The normal map of the pattern's height; +Y is up in the image, as in glTF.
Image normalImage(std::string name, int size, const Pattern& pattern);

}  // namespace host::textures
