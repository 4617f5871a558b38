#include "tests/support/ssao_reference.h"

#include <algorithm>

namespace mres::test {

SsaoReference::SsaoReference(const SyntheticGBuffer& gbuffer, const SsaoSettings& settings)
    : hemisphere_(gbuffer, {.radius = static_cast<double>(settings.radius),
                            .bias = static_cast<double>(settings.bias),
                            .samples = settings.samples,
                            .seed = settings.seed}),
      intensity_(static_cast<double>(settings.intensity)) {}

double SsaoReference::accessibility(glm::ivec2 pixel) const {
  if (hemisphere_.isBackground(pixel)) return 1.0;
  const std::vector<Sight> sights = hemisphere_.sightsFrom(pixel);
  double occlusion = 0.0;
  for (const Sight& sight : sights) occlusion += sight.blocked;
  const double mean = occlusion / static_cast<double>(sights.size());
  return std::clamp(1.0 - intensity_ * mean, 0.0, 1.0);
}

}  // namespace mres::test
