#include "tests/support/ssao_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "effects/ssao/sample_points.h"

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

SsaoReference::SsaoReference(const SyntheticGBuffer& gbuffer, const SsaoSettings& settings)
    : gbuffer_(gbuffer),
      settings_(settings),
      points_(hemispherePoints(settings.samples, settings.seed)),
      projection_(gbuffer.frame().projection),
      inverseProjection_(glm::inverse(projection_)) {}

bool SsaoReference::isBackground(glm::ivec2 pixel) const {
  const auto index = static_cast<std::size_t>(pixel.y * gbuffer_.frame().size.x + pixel.x);
  return gbuffer_.depths().at(index) == 1.0f;
}

glm::dvec3 SsaoReference::positionOf(glm::ivec2 pixel) const {
  const glm::ivec2 size = gbuffer_.frame().size;
  const double depth =
      static_cast<double>(gbuffer_.depths().at(static_cast<std::size_t>(pixel.y * size.x + pixel.x)));
  const glm::dvec3 window((glm::dvec2(pixel) + 0.5) / glm::dvec2(size), depth);
  const glm::dvec4 position = inverseProjection_ * glm::dvec4(window * 2.0 - 1.0, 1.0);
  return glm::dvec3(position) / position.w;
}

double SsaoReference::accessibility(glm::ivec2 pixel) const {
  if (isBackground(pixel)) return 1.0;
  const glm::ivec2 size = gbuffer_.frame().size;
  const glm::dvec3 normal(gbuffer_.normals().at(static_cast<std::size_t>(pixel.y * size.x + pixel.x)));
  const glm::dvec3 origin = positionOf(pixel);
  const double originW = (projection_ * glm::dvec4(origin, 1.0)).w;
  const glm::dmat3 frame = turnedFrame(glm::normalize(normal), pixel);
  double occlusion = 0.0;
  for (const glm::dvec3 sample : points_) {
    const glm::dvec3 point = origin + static_cast<double>(settings_.radius) * (frame * sample);
    occlusion += occlusionOf(point, std::log2(glm::length(sample)), origin, frame[2], originW);
  }
  const double mean = occlusion / static_cast<double>(points_.size());
  return std::clamp(1.0 - static_cast<double>(settings_.intensity) * mean, 0.0, 1.0);
}

double SsaoReference::occlusionOf(glm::dvec3 point, double log2Length, glm::dvec3 origin, glm::dvec3 normal,
                                  double originW) const {
  const glm::ivec2 size = gbuffer_.frame().size;
  const double radius = static_cast<double>(settings_.radius);
  const double radiusInPixels = radius * std::abs(projection_[1][1]) * 0.5 * size.y / originW;
  const int mip =
      std::clamp(static_cast<int>(std::log2(radiusInPixels) - 3.0 + log2Length), 0, mipCount(size) - 1);

  const glm::dvec4 clip = projection_ * glm::dvec4(point, 1.0);
  const glm::dvec2 projected = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(size);
  const glm::ivec2 pixel = glm::clamp(glm::ivec2(projected), glm::ivec2(0), size - 1);
  const glm::ivec2 texel = glm::min(pixel >> mip, glm::max(size >> mip, glm::ivec2(1)) - 1);
  const glm::ivec2 seen = glm::min(texel * (1 << mip) + (1 << mip) / 2, size - 1);
  if (isBackground(seen)) return 0.0;

  const glm::dvec3 position = positionOf(seen);
  const glm::dvec3 toSurface = position - origin;
  const bool inFront = -position.z < -point.z;
  const bool rises = glm::dot(toSurface, normal) > radius * static_cast<double>(settings_.bias);
  const double reach = radius * radius;
  return inFront && rises
             ? std::clamp((4.0 * reach - glm::dot(toSurface, toSurface)) / (3.0 * reach), 0.0, 1.0)
             : 0.0;
}

UnfilteredSsao::UnfilteredSsao(const SsaoSettings& settings)
    : ssao_(settings), description_(ssao_.description()) {
  description_.name = "unfiltered ssao";
  description_.filtered = false;
}

}  // namespace mres::test
