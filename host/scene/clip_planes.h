#pragma once

#include "host/scene/scene.h"

namespace host {

/// Sets near and far plane so that everything within `bounds` that is in front of the camera is inside, while
/// the ratio of the planes, which is what depth precision depends on, stays bounded.
void fitClipPlanes(Camera& camera, const Bounds& bounds);

}  // namespace host
