#pragma once

#include <optional>

#include "host/renderer/shadow/shadow_view.h"
#include "host/scene/scene.h"

namespace host {

/// A spot light's view of the scene: its cone, as far as light and scene reach. Of a cone wider than 160
/// degrees the rim lies outside of the map, and is lit without shadow. Nothing if none of the scene is there.
std::optional<ShadowView> spotView(const Light& light, const Bounds& scene, int mapSize);

}  // namespace host
