#include "host/renderer/camera_view.h"

namespace host {
namespace {

glm::mat4 rotationOf(Camera camera) {
  camera.position = glm::vec3(0.0f);
  return viewMatrix(camera);
}

}  // namespace

CameraView::CameraView(const Camera& camera, glm::ivec2 size)
    : origin(camera.position),
      rotation(rotationOf(camera)),
      projection(projectionMatrix(camera, static_cast<float>(size.x) / static_cast<float>(size.y))),
      worldToClip(glm::dmat4(projection) * glm::dmat4(rotation)),
      forward(-glm::vec3(glm::transpose(rotation)[2])),
      orthographic(camera.orthographicHeight.has_value()) {}

mres::params::ViewParams CameraView::params() const {
  mres::params::ViewParams params{};
  params.worldToClip = worldToClip;
  // The inverse in double precision: a near plane a thousandth of the far plane costs float most of its
  // digits.
  params.clipToWorld = glm::mat4(glm::inverse(glm::dmat4(projection) * glm::dmat4(rotation)));
  params.eye = orthographic ? glm::vec4(-forward, 0.0f) : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  return params;
}

}  // namespace host
