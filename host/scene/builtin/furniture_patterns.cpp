#include "host/scene/builtin/furniture_patterns.h"

#include <cmath>

namespace host::furniture {

namespace {

using textures::cellNoise;
using textures::fractalNoise;
using textures::Pattern;
using textures::Surface;

/// How much of row `row` is covered with words: words are runs of random length in a line of random length.
bool isInk(glm::vec2 at, int row, std::uint32_t seed) {
  const float lineEnd = 0.6f + 0.4f * cellNoise({row, 1}, seed);
  const int word = static_cast<int>(at.x * 14.0f + 3.0f * cellNoise({row, 2}, seed));
  const float fraction = glm::fract(at.x * 14.0f + 3.0f * cellNoise({row, 2}, seed));
  return at.x < lineEnd && fraction < 0.55f + 0.4f * cellNoise({row, word}, seed);
}

}  // namespace

Pattern mottled(glm::vec3 a, glm::vec3 b, int cells, float relief, std::uint32_t seed) {
  return [=](glm::vec2 uv) {
    const float n = fractalNoise(uv * static_cast<float>(cells), glm::ivec2(cells), 4, seed);
    const float contrast = glm::smoothstep(0.3f, 0.7f, n);
    return Surface{glm::mix(a, b, contrast), relief * n};
  };
}

Pattern acousticTile() {
  return [](glm::vec2 uv) {
    constexpr int kHoles = 64;
    const glm::vec2 scaled = uv * static_cast<float>(kHoles);
    const glm::ivec2 cell(scaled);
    const float radius = 0.12f + 0.28f * cellNoise(cell, 11);
    const bool hole =
        cellNoise(cell, 12) < 0.45f && glm::distance(glm::fract(scaled), glm::vec2(0.5f)) < radius;
    const float worm = fractalNoise(uv * 24.0f, glm::ivec2(24), 2, 13);
    const bool fissure = std::abs(worm - 0.5f) < 0.008f;
    const bool deep = hole || fissure;
    return Surface{glm::vec3(deep ? 0.66f : 0.9f), deep ? -0.002f : 0.0f};
  };
}

Pattern rugField(glm::vec3 ground) {
  return [=](glm::vec2 uv) {
    constexpr float kSteps = 48.0f;  // knots a repeat, which step the outlines
    const glm::vec2 knot = (glm::floor(uv * kSteps) + 0.5f) / kSteps;
    const glm::vec2 p = glm::abs(knot * 2.0f - 1.0f);
    const float diamond = p.x + p.y;
    const float corner = 2.0f - diamond;
    glm::vec3 color = ground;
    if (diamond < 0.9f) color = glm::vec3(0.27f, 0.32f, 0.42f);
    if (diamond < 0.78f) color = glm::vec3(0.84f, 0.76f, 0.6f);
    if (diamond < 0.68f) color = ground * 0.8f;
    if (diamond < 0.42f) color = glm::vec3(0.84f, 0.76f, 0.6f);
    if (diamond < 0.3f) color = glm::vec3(0.27f, 0.32f, 0.42f);
    if (corner < 0.4f) color = glm::vec3(0.72f, 0.5f, 0.28f);
    if (corner < 0.22f) color = glm::vec3(0.27f, 0.32f, 0.42f);
    const glm::ivec2 cell(uv * 192.0f);
    const float wool = 0.86f + 0.2f * cellNoise(cell, 21);
    return Surface{glm::min(color * wool, glm::vec3(1.0f)), 0.0012f * cellNoise(cell, 22)};
  };
}

Pattern printedPage() {
  return [](glm::vec2 uv) {
    const glm::vec3 white(0.93f, 0.92f, 0.9f);
    const glm::vec2 body = (uv - glm::vec2(0.12f, 0.1f)) / glm::vec2(0.76f, 0.8f);
    if (body.x < 0.0f || body.x > 1.0f || body.y < 0.0f || body.y > 1.0f) return Surface{white, 0.0f};
    const int row = static_cast<int>(body.y * 34.0f);
    const float inRow = glm::fract(body.y * 34.0f);
    const bool heading = row < 2;
    const bool blank = row == 2 || row % 9 == 0;
    if (heading && body.x < 0.6f && body.y < 0.045f) return Surface{glm::vec3(0.2f, 0.24f, 0.4f), 0.0f};
    const bool ink = !heading && !blank && inRow > 0.25f && inRow < 0.7f && isInk(body, row, 31);
    return Surface{ink ? glm::vec3(0.45f) : white, 0.0f};
  };
}

Pattern screenPicture() {
  return [](glm::vec2 uv) {
    if (uv.y < 0.045f) return Surface{glm::vec3(0.3f, 0.33f, 0.38f), 0.0f};
    const bool sideBar = uv.x < 0.2f;
    const glm::vec3 ground = sideBar ? glm::vec3(0.17f, 0.19f, 0.23f) : glm::vec3(0.12f, 0.13f, 0.16f);
    const int row = static_cast<int>(uv.y * 36.0f);
    const float inRow = glm::fract(uv.y * 36.0f);
    const float indent = sideBar ? 0.02f : 0.24f + 0.03f * std::floor(4.0f * cellNoise({row / 2, 0}, 41));
    const float x = (uv.x - indent) / (sideBar ? 0.2f : 0.6f);
    const bool ink = x > 0.0f && inRow > 0.3f && inRow < 0.72f && cellNoise({row, 9}, 42) > 0.15f &&
                     isInk({x, uv.y}, row, 43) && x < 0.75f;
    if (!ink) return Surface{ground, 0.0f};
    const float hue = cellNoise({row, static_cast<int>(x * 9.0f)}, 44);
    const glm::vec3 blue(0.45f, 0.66f, 0.92f);
    const glm::vec3 green(0.6f, 0.8f, 0.5f);
    return Surface{hue < 0.4f ? glm::vec3(0.8f, 0.82f, 0.84f) : (hue < 0.7f ? blue : green), 0.0f};
  };
}

Pattern landscape() {
  return [](glm::vec2 uv) {
    const auto ridge = [&](float height, float rough, std::uint32_t seed) {
      return height + rough * (fractalNoise({uv.x * 6.0f, 0.5f}, {6, 1}, 5, seed) - 0.5f);
    };
    const float brush = fractalNoise(uv * glm::vec2(40.0f, 60.0f), {40, 60}, 3, 51) - 0.5f;
    glm::vec3 color = glm::mix(glm::vec3(0.45f, 0.6f, 0.78f), glm::vec3(0.95f, 0.85f, 0.68f), uv.y * 1.7f);
    const float cloud = fractalNoise(uv * glm::vec2(5.0f, 12.0f), {5, 12}, 5, 52);
    color = glm::mix(color, glm::vec3(0.97f, 0.93f, 0.88f), glm::smoothstep(0.5f, 0.7f, cloud));
    if (uv.y > ridge(0.45f, 0.25f, 53)) color = {0.42f, 0.5f, 0.58f};
    if (uv.y > ridge(0.55f, 0.2f, 54)) color = {0.33f, 0.43f, 0.37f};
    if (uv.y > 0.64f)
      color = glm::mix(glm::vec3(0.72f, 0.74f, 0.7f), glm::vec3(0.3f, 0.42f, 0.5f), uv.y * 2.6f - 1.6f);
    if (uv.y > ridge(0.86f, 0.28f, 55)) color = {0.3f, 0.33f, 0.16f};
    return Surface{glm::clamp(color + 0.16f * brush, 0.0f, 1.0f), 0.002f * brush};
  };
}

}  // namespace host::furniture
