#pragma once

#include "host/scene/scene.h"
#include "shaders/host/environment_params.h"

namespace host {

/// The sky, and the scene's ambient light tinted by it from above and below.
mres::params::EnvironmentParams environmentParams(const Scene& scene);

}  // namespace host
