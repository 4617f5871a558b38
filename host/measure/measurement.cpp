#include "host/measure/measurement.h"

#include <fmt/format.h>

namespace host {

Measurement describePicture(const Scene& scene, const PictureSettings& settings, int camera,
                            glm::ivec2 size) {
  Measurement measurement;
  measurement.scene = scene.name;
  measurement.triangles = triangleCount(scene);
  measurement.camera = camera;
  measurement.cameraName = scene.cameras.at(camera).name;
  measurement.size = size;
  measurement.effect = settings.effect;
  measurement.samples = sampleCount(settings);
  measurement.technique = settings.technique;
  return measurement;
}

std::vector<std::string> warningsOf(const Scene& scene, const Renderer& renderer) {
  std::vector<std::string> warnings = scene.warnings;
  if (const std::size_t count = renderer.lightsLeftOut(); count > 0)
    warnings.push_back(fmt::format("{} of its lights, the dimmest, {} left out: there are more than fit.",
                                   count, count == 1 ? "is" : "are"));
  return warnings;
}

}  // namespace host
