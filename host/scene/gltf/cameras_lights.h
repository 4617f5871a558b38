#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "host/scene/gltf/document.h"
#include "host/scene/gltf/nodes.h"
#include "host/scene/scene.h"

namespace host::gltf {

/// The node's camera; nothing, with a warning, where it is broken. Impossible clipping planes are made to fit
/// `bounds`, the scene's.
std::optional<Camera> convertCamera(Document& document, const PlacedNode& placed, const Bounds& bounds);

/// The node's light (KHR_lights_punctual); nothing, with a warning, where it is broken.
std::optional<Light> convertLight(Document& document, const PlacedNode& placed);

}  // namespace host::gltf
