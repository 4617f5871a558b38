#include "tests/support/hemisphere_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mres::test {
namespace {

constexpr std::array<int, 16> kBayer = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
constexpr int kMaxMips = 6;

/// Columns: tangent, bitangent, normal (Duff et al. 2017), turned around the normal by the pixel's azimuth.
glm::dmat3 turnedFrame(glm::dvec3 n, glm::ivec2 pixel) {
  const double s = n.z >= 0.0 ? 1.0 : -1.0;
  const double a = -1.0 / (s + n.z);
  const glm::dvec3 tangent(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
  const glm::dvec3 bitangent(n.x * n.y * a, s + n.y * n.y * a, -n.y);
  const int turn = kBayer.at(static_cast<std::size_t>(pixel.y % 4 * 4 + pixel.x % 4));
  const double azimuth = turn * std::numbers::pi / 8.0;
  return {std::cos(azimuth) * tangent + std::sin(azimuth) * bitangent,
          std::cos(azimuth) * bitangent - std::sin(azimuth) * tangent, n};
}

int mipCount(glm::ivec2 size) {
  int count = 1;
  while (count < kMaxMips && (std::min(size.x, size.y) >> count) > 0) ++count;
  return count;
}

}  // namespace

HemisphereReference::HemisphereReference(const SyntheticGBuffer& gbuffer, const HemisphereSettings& settings)
    : gbuffer_(gbuffer),
      settings_(settings),
      points_(hemispherePoints(settings.samples, settings.seed)),
      projection_(gbuffer.frame().projection),
      inverseProjection_(glm::inverse(projection_)) {}

std::size_t HemisphereReference::indexOf(glm::ivec2 pixel) const {
  return static_cast<std::size_t>(pixel.y * gbuffer_.frame().size.x + pixel.x);
}

bool HemisphereReference::isBackground(glm::ivec2 pixel) const {
  return gbuffer_.depths().at(indexOf(pixel)) == 1.0f;
}

glm::dvec3 HemisphereReference::normalOf(glm::ivec2 pixel) const {
  return glm::normalize(glm::dvec3(gbuffer_.normals().at(indexOf(pixel))));
}

glm::dvec3 HemisphereReference::positionOf(glm::ivec2 pixel) const {
  const auto depth = static_cast<double>(gbuffer_.depths().at(indexOf(pixel)));
  const glm::dvec3 window((glm::dvec2(pixel) + 0.5) / glm::dvec2(gbuffer_.frame().size), depth);
  const glm::dvec4 position = inverseProjection_ * glm::dvec4(window * 2.0 - 1.0, 1.0);
  return glm::dvec3(position) / position.w;
}

std::vector<Sight> HemisphereReference::sightsFrom(glm::ivec2 pixel) const {
  const glm::dvec3 position = positionOf(pixel);
  const Receiver from{position, turnedFrame(normalOf(pixel), pixel),
                      (projection_ * glm::dvec4(position, 1.0)).w};
  std::vector<Sight> sights;
  sights.reserve(points_.size());
  for (const glm::dvec3 sample : points_) sights.push_back(sightOf(sample, from));
  return sights;
}

int HemisphereReference::mipAt(double distance, double originW) const {
  const glm::ivec2 size = gbuffer_.frame().size;
  const double radiusInPixels = settings_.radius * std::abs(projection_[1][1]) * 0.5 * size.y / originW;
  return std::clamp(static_cast<int>(std::log2(radiusInPixels) - 3.0 + std::log2(distance)), 0,
                    mipCount(size) - 1);
}

glm::ivec2 HemisphereReference::pixelSeenAt(glm::dvec3 point, int mip) const {
  const glm::ivec2 size = gbuffer_.frame().size;
  const glm::dvec4 clip = projection_ * glm::dvec4(point, 1.0);
  const glm::dvec2 projected = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(size);
  const glm::ivec2 pixel = glm::clamp(glm::ivec2(projected), glm::ivec2(0), size - 1);
  const glm::ivec2 texel = glm::min(pixel >> mip, glm::max(size >> mip, glm::ivec2(1)) - 1);
  return glm::min(texel * (1 << mip) + (1 << mip) / 2, size - 1);
}

Sight HemisphereReference::sightOf(glm::dvec3 sample, const Receiver& from) const {
  const glm::dvec3 offset = from.frame * sample;
  const glm::dvec3 point = from.position + settings_.radius * offset;
  const int mip = mipAt(glm::length(sample), from.clipW);
  Sight sight{.direction = glm::normalize(offset),
              .toSurface = glm::dvec3(0.0),
              .pixel = pixelSeenAt(point, mip),
              .mip = mip,
              .blocked = 0.0};
  if (isBackground(sight.pixel)) return sight;

  const glm::dvec3 position = positionOf(sight.pixel);
  sight.toSurface = position - from.position;
  const bool inFront = -position.z < -point.z;
  const bool rises = glm::dot(sight.toSurface, from.frame[2]) > settings_.radius * settings_.bias;
  const double reach = settings_.radius * settings_.radius;
  if (inFront && rises) {
    const double distance2 = glm::dot(sight.toSurface, sight.toSurface);
    sight.blocked = std::clamp((4.0 * reach - distance2) / (3.0 * reach), 0.0, 1.0);
  }
  return sight;
}

}  // namespace mres::test
