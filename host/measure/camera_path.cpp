#include "host/measure/camera_path.h"

#include <algorithm>
#include <cstdlib>

namespace host {
namespace {

// How many steps the path goes each way. Different ones, so that the way back is not the way there.
constexpr int kStepsForward = 8;
constexpr int kStepsTurned = 11;

constexpr float kLargestShareOfScene = 0.001f;  // that a step may be

/// Steps from the middle after `steps` between -reach and reach, one way and back.
float swing(int steps, int reach) {
  return static_cast<float>(reach - std::abs((steps + reach) % (4 * reach) - 2 * reach));
}

}  // namespace

Camera cameraAt(const Camera& camera, const CameraPath& path, const Bounds& scene, int frame) {
  const float step = std::min(path.metres, kLargestShareOfScene * glm::distance(scene.min, scene.max));
  const glm::vec3 forward = camera.orientation * glm::vec3(0.0f, 0.0f, -1.0f);
  const float angle = glm::radians(path.degrees) * swing(frame, kStepsTurned);
  Camera moved = camera;
  moved.position += step * swing(frame, kStepsForward) * forward;
  moved.orientation = camera.orientation * glm::angleAxis(angle, glm::vec3(0.0f, 1.0f, 0.0f));
  return moved;
}

}  // namespace host
