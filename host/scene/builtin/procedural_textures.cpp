#include "host/scene/builtin/procedural_textures.h"

#include <algorithm>
#include <cmath>

namespace host::textures {
namespace {

/// A bijective mixer of 32 bits; constants by Chris Wellons' hash prospector ("lowbias32").
std::uint32_t mixed(std::uint32_t x) {
  x ^= x >> 16U;
  x *= 0x7feb352dU;
  x ^= x >> 15U;
  x *= 0x846ca68bU;
  x ^= x >> 16U;
  return x;
}

/// A real coordinate on a ring of `period` cells: the cells on both sides and the place between them.
struct RingPosition {
  std::uint32_t left, right;
  float between;

  RingPosition(float at, int period) {
    int cell = static_cast<int>(at);
    if (static_cast<float>(cell) > at) --cell;  // std::floor is a slow call without SSE 4.1
    const float in = at - static_cast<float>(cell);
    cell = (cell % period + period) % period;
    left = static_cast<std::uint32_t>(cell);
    right = static_cast<std::uint32_t>(cell + 1 == period ? 0 : cell + 1);
    between = in * in * in * (in * (in * 6.0f - 15.0f) + 10.0f);  // Perlin's fade of 2002: smooth relief
  }
};

/// The upper 24 bits as a fraction.
float fraction(std::uint32_t hash) {
  return static_cast<float>(hash >> 8U) * 0x1p-24f;
}

std::uint8_t quantised(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

/// Fills an image with `texel`, a colour by pixel.
template <typename Texel>
Image drawn(std::string name, int size, const Texel& texel) {
  Image image{std::move(name), glm::ivec2(size), {}};
  image.pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const glm::vec3 color = texel(x, y);
      for (int i = 0; i < 3; ++i) image.pixels.push_back(quantised(color[i]));
      image.pixels.push_back(255);
    }
  }
  return image;
}

glm::vec2 centreOf(int x, int y, int size) {
  return (glm::vec2(x, y) + 0.5f) / static_cast<float>(size);
}

}  // namespace

float cellNoise(glm::ivec2 cell, std::uint32_t seed) {
  return fraction(
      mixed(static_cast<std::uint32_t>(cell.x) ^ mixed(static_cast<std::uint32_t>(cell.y) ^ mixed(seed))));
}

float valueNoise(glm::vec2 at, glm::ivec2 period, std::uint32_t seed) {
  const RingPosition x(at.x, period.x);
  const RingPosition y(at.y, period.y);
  const std::uint32_t lattice = mixed(seed);
  const auto alongRow = [&](std::uint32_t row) {
    const std::uint32_t hash = mixed(row ^ lattice);
    return glm::mix(fraction(mixed(x.left ^ hash)), fraction(mixed(x.right ^ hash)), x.between);
  };
  return glm::mix(alongRow(y.left), alongRow(y.right), y.between);
}

float fractalNoise(glm::vec2 at, glm::ivec2 period, int octaves, std::uint32_t seed) {
  float sum = 0.0f;
  float total = 0.0f;
  float weight = 1.0f;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * valueNoise(at, period, seed + static_cast<std::uint32_t>(i));
    total += weight;
    weight *= 0.5f;
    at *= 2.0f;
    period *= 2;
  }
  return sum / total;
}

Image baseColorImage(std::string name, int size, const Pattern& pattern) {
  return drawn(std::move(name), size, [&](int x, int y) { return pattern(centreOf(x, y, size)).color; });
}

Image normalImage(std::string name, int size, const Pattern& pattern) {
  std::vector<float> heights;
  heights.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) heights.push_back(pattern(centreOf(x, y, size)).height);
  }
  const auto height = [&](int x, int y) { return heights[(y + size) % size * size + (x + size) % size]; };
  return drawn(std::move(name), size, [&](int x, int y) {
    const float perTexel = 0.5f * static_cast<float>(size);
    const glm::vec3 normal =
        glm::normalize(glm::vec3((height(x - 1, y) - height(x + 1, y)) * perTexel,
                                 (height(x, y + 1) - height(x, y - 1)) * perTexel, 1.0f));
    return normal * 0.5f + 0.5f;
  });
}

}  // namespace host::textures
