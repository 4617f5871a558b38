#include "tests/support/ssgi_reference.h"

#include <algorithm>
#include <cmath>

namespace mres::test {

LitPicture::LitPicture(glm::ivec2 pictureSize, const std::function<glm::vec3(glm::ivec2 pixel)>& colourOf)
    : size(pictureSize) {
  for (int i = 0; i < size.x * size.y; ++i) {
    texels.emplace_back(colourOf({i % size.x, i / size.x}), 1.0f);
  }
  texture = gl::Texture2D(GL_RGBA32F, size, "test.lit", 1, texels.data());
}

LitPicture uniformPicture(glm::ivec2 size, glm::vec3 colour) {
  return {size, [=](glm::ivec2) { return colour; }};
}

LitPicture facingPicture(const SyntheticGBuffer& gbuffer, glm::vec3 direction, glm::vec3 there,
                         glm::vec3 elsewhere) {
  const glm::ivec2 size = gbuffer.frame().size;
  return {
      size, [&](glm::ivec2 pixel) {
        const glm::vec3 normal(gbuffer.normals().at(static_cast<std::size_t>(pixel.y * size.x + pixel.x)));
        return glm::dot(normal, direction) > 0.5f ? there : elsewhere;
      }};
}

SsgiReference::SsgiReference(const SyntheticGBuffer& gbuffer, const LitPicture& lit,
                             const SsgiSettings& settings, const SsgiInputs& inputs)
    : hemisphere_(gbuffer, {.radius = static_cast<double>(settings.radius),
                            .bias = static_cast<double>(settings.bias),
                            .samples = settings.samples,
                            .seed = settings.seed}),
      lit_(lit),
      settings_(settings),
      inputs_(inputs) {}

glm::dvec3 SsgiReference::environment(glm::dvec3 direction) const {
  const double height = glm::dot(direction, glm::dvec3(inputs_.up));
  return glm::mix(glm::dvec3(inputs_.environmentBelow), glm::dvec3(inputs_.environmentAbove),
                  0.5 + 0.5 * height);
}

glm::dvec3 SsgiReference::sanitised(glm::ivec2 pixel) const {
  if (hemisphere_.isBackground(pixel)) return glm::dvec3(0.0);
  glm::dvec3 radiance(lit_.texels.at(static_cast<std::size_t>(pixel.y * lit_.size.x + pixel.x)));
  for (int channel = 0; channel < 3; ++channel) {
    const double scaled = radiance[channel] * static_cast<double>(inputs_.radianceScale);
    radiance[channel] = std::isfinite(radiance[channel])
                            ? std::clamp(scaled, 0.0, static_cast<double>(settings_.maxRadiance))
                            : 0.0;
  }
  return radiance;
}

glm::dvec3 SsgiReference::meanSent(glm::ivec2 texel, int mip) const {
  if (mip == 0) return sanitised(texel);
  const auto ownPixel = [&](glm::ivec2 place, int level) {
    return glm::min(place * (1 << level) + (1 << level) / 2, lit_.size - 1);
  };
  const glm::ivec2 lastPart =
      mip == 1 ? lit_.size - 1 : glm::max((lit_.size + 1) / 2 / (1 << (mip - 2)), glm::ivec2(1)) - 1;
  const bool own = !hemisphere_.isBackground(ownPixel(texel, mip));
  const glm::dvec3 normal = hemisphere_.normalOf(ownPixel(texel, mip));
  glm::dvec3 part(0.0);
  glm::dvec3 sum(0.0);
  int count = 0;
  for (int i = 0; i < 4; ++i) {
    const glm::ivec2 place = glm::min(2 * texel + glm::ivec2(i % 2, i / 2), lastPart);
    const glm::ivec2 pixel = ownPixel(place, mip - 1);
    part = meanSent(place, mip - 1);
    if (hemisphere_.isBackground(pixel)) continue;
    if (own && !(glm::dot(hemisphere_.normalOf(pixel), normal) > 0.5)) continue;
    sum += part;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : part;
}

glm::dvec3 SsgiReference::sentBy(const Sight& sender) const {
  if (glm::dot(hemisphere_.normalOf(sender.pixel), -sender.toSurface) <= 0.0) return glm::dvec3(0.0);
  const int mip = std::max(sender.mip, 1);
  return static_cast<double>(settings_.intensity) * meanSent(sender.pixel / (1 << mip), mip);
}

glm::dvec3 SsgiReference::arriving(glm::ivec2 pixel) const {
  if (hemisphere_.isBackground(pixel))
    return 0.5 * glm::dvec3(inputs_.environmentAbove + inputs_.environmentBelow);
  const std::vector<Sight> sights = hemisphere_.sightsFrom(pixel);
  glm::dvec3 sum(0.0);
  for (const Sight& sight : sights) {
    sum += (1.0 - sight.blocked) * environment(sight.direction);
    if (sight.blocked > 0.0) sum += sight.blocked * sentBy(sight);
  }
  return sum / static_cast<double>(sights.size());
}

}  // namespace mres::test
