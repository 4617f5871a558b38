#pragma once

#include <vector>

#include "host/scene/scene.h"

namespace host {

/// Eight different cameras for a scene that brings none: views across rooms for an interior, views around the
/// outside for an object or a landscape. None is inside of something solid, and each looks at geometry. The
/// same scene always gets the same cameras.
std::vector<Camera> automaticCameras(const Scene& scene);

}  // namespace host
