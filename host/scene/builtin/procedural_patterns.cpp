#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "host/scene/builtin/procedural_textures.h"

namespace host::textures {
namespace {

glm::vec3 brightened(glm::vec3 color, float factor) {
  return glm::clamp(color * factor, 0.0f, 1.0f);
}

/// 0 in a joint around the cell's border, 1 inside; `in` is the place in the cell and `width` half a joint,
/// both as fractions of the cell.
float insideJoints(glm::vec2 in, glm::vec2 width) {
  const glm::vec2 border = glm::min(in, 1.0f - in) / width;
  return glm::smoothstep(0.7f, 1.3f, std::min(border.x, border.y));
}

}  // namespace

Pattern wood(glm::vec3 light, glm::vec3 dark, int planks, std::uint32_t seed) {
  return [=](glm::vec2 uv) {
    const float across = uv.y * static_cast<float>(planks);
    const int plank = std::min(static_cast<int>(across), planks - 1);
    const auto own = seed + 101U * static_cast<std::uint32_t>(plank + 1);
    // Growth rings cut lengthways: bands across the board, bent by slow noise along it.
    const float bend = fractalNoise({uv.x * 3.0f, uv.y * 8.0f}, {3, 8}, 3, own);
    const float ringPhase = 5.0f * uv.y + 1.6f * bend;
    const float rings = 0.5f + 0.5f * std::sin(glm::two_pi<float>() * ringPhase);
    const float fibres = fractalNoise({uv.x * 8.0f, uv.y * 128.0f}, {8, 128}, 3, own + 7U);
    const float shade = 0.45f * rings + 0.55f * fibres;
    const float ownShade = 0.9f + 0.2f * cellNoise({plank, 0}, seed);
    Surface surface;
    surface.color = brightened(glm::mix(dark, light, shade), planks > 1 ? ownShade : 1.0f);
    surface.height = 0.0012f * fibres;
    if (planks > 1) {
      const float seam = insideJoints({0.5f, across - static_cast<float>(plank)}, glm::vec2(0.012f));
      surface.color *= 0.35f + 0.65f * seam;
      surface.height += 0.003f * seam;
    }
    return surface;
  };
}

Pattern marble(glm::vec3 base, glm::vec3 vein, float veins, std::uint32_t seed) {
  return [=](glm::vec2 uv) {
    const glm::vec2 bend(fractalNoise(uv * 4.0f, {4, 4}, 4, seed),
                         fractalNoise(uv * 4.0f, {4, 4}, 4, seed + 50U));
    const float clouds = fractalNoise(uv * 3.0f + bend, {3, 3}, 5, seed + 11U);
    // Veins follow the zero crossings of a bent noise field.
    const float field = fractalNoise(uv * 2.0f + 1.2f * bend, {2, 2}, 4, seed + 23U) - 0.5f;
    const float line = std::exp(-std::abs(field) * 45.0f);
    const float amount = std::clamp(0.45f * (clouds - 0.35f) + veins * line, 0.0f, 1.0f);
    return Surface{glm::mix(base, vein, amount), 0.0f};
  };
}

Pattern plaster(glm::vec3 color, float contrast, std::uint32_t seed) {
  return [=](glm::vec2 uv) {
    const float broad = fractalNoise(uv * 4.0f, {4, 4}, 4, seed);
    const float fine = fractalNoise(uv * 48.0f, {48, 48}, 3, seed + 31U);
    const float shade = 1.0f + contrast * (0.65f * broad + 0.35f * fine - 0.5f);
    return Surface{brightened(color, shade), 0.0025f * fine + 0.004f * broad};
  };
}

Pattern fabric(glm::vec3 warp, glm::vec3 weft, int threads, std::uint32_t seed) {
  return [=](glm::vec2 uv) {
    const glm::vec2 at = uv * static_cast<float>(threads);
    const glm::ivec2 thread = glm::min(glm::ivec2(at), glm::ivec2(threads - 1));
    const glm::vec2 in = at - glm::vec2(thread);
    const bool warpOnTop = (thread.x + thread.y) % 2 == 0;
    const float across = warpOnTop ? in.x : in.y;
    const float along = warpOnTop ? in.y : in.x;
    // A thread is a half cylinder that dives under its neighbours.
    const float roundness = std::sqrt(std::max(0.0f, 1.0f - 3.6f * (across - 0.5f) * (across - 0.5f)));
    const float arch = std::sin(glm::pi<float>() * along);
    const float own = cellNoise({warpOnTop ? thread.x : -1, warpOnTop ? -1 : thread.y}, seed);
    const float shade = (0.9f + 0.2f * own) * (0.6f + 0.4f * roundness * (0.5f + 0.5f * arch));
    return Surface{brightened(warpOnTop ? warp : weft, shade),
                   0.4f * roundness * arch / static_cast<float>(threads)};
  };
}

Pattern masonry(const Masonry& masonry, Pattern block, std::uint32_t seed) {
  return [=, block = std::move(block)](glm::vec2 uv) {
    const glm::vec2 cells(masonry.blocks);
    const int row = std::min(static_cast<int>(uv.y * cells.y), masonry.blocks.y - 1);
    const float shift = row % 2 == 0 ? 0.0f : masonry.stagger;
    const glm::vec2 at(uv.x * cells.x + shift, uv.y * cells.y);
    const glm::ivec2 cell(static_cast<int>(at.x) % masonry.blocks.x, row);
    const float inside = insideJoints(glm::fract(at), 0.5f * masonry.joint * cells);
    // Each block is cut from another place of the same stone.
    const glm::vec2 cut(cellNoise(cell, seed), cellNoise(cell, seed + 1U));
    Surface surface = block(glm::fract(uv + cut));
    const float shade = 1.0f + masonry.shadeVariation * (cellNoise(cell, seed + 2U) - 0.5f);
    surface.color = glm::mix(masonry.jointColor, brightened(surface.color, shade), inside);
    surface.height = surface.height * inside + 0.4f * masonry.joint * inside;
    return surface;
  };
}

Pattern checker(int cells, Pattern even, Pattern odd, glm::vec3 jointColor) {
  return [=, even = std::move(even), odd = std::move(odd)](glm::vec2 uv) {
    const glm::vec2 at = uv * static_cast<float>(cells);
    const glm::ivec2 cell(at);
    const float inside = insideJoints(glm::fract(at), glm::vec2(0.008f));
    const glm::vec2 cut(cellNoise(cell, 71U), cellNoise(cell, 72U));
    Surface surface = (cell.x + cell.y) % 2 == 0 ? even(glm::fract(uv + cut)) : odd(glm::fract(uv + cut));
    surface.color = glm::mix(jointColor, surface.color, inside);
    surface.height = 0.002f * inside;
    return surface;
  };
}

}  // namespace host::textures
