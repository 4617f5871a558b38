#include "host/measure/measurement.h"

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
  measurement.technique = nameOf(settings.technique);
  return measurement;
}

}  // namespace host
