#pragma once

#include "host/scene/scene.h"

namespace host {

/// The factor on radiance that shows a scene well, from what its lights bring into it: the same for every
/// camera, size and effect, so that pictures can be compared.
float exposureOf(const Scene& scene, const Bounds& bounds);

}  // namespace host
