#include "tests/gpu/soft_shadows_support.h"

namespace mres::test {

RayCaster floorWithBox() {
  return nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-1.0, -1.0, -7.0}, {1.0, 1.0, -5.0})});
}

Image SoftShadowsTest::render(const RayCaster& scene, const SyntheticLight& light,
                              const SoftShadowSettings& settings, glm::ivec2 size) {
  const SyntheticGBuffer gbuffer(size, perspective(size), scene);
  const SyntheticShadow shadow(scene, light, kMapSize);
  multiResolution_.settings().technique = Technique::full;
  effect_.setSettings(settings);
  effect_.setInputs(shadow.inputs());
  return {size, 1, renderPicture(multiResolution_, effect_, gbuffer.frame())};
}

}  // namespace mres::test
