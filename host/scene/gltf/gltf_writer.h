#pragma once

#include <span>
#include <string>

#include "host/scene/scene.h"

namespace host {

/// The bytes of a .glb file of what other renderers need to see the same surfaces from the same places:
/// triangles, normals, base colours, holes of alpha masks, and of the scene's cameras those that are
/// numbered. Lights and textures that cut no holes are left out.
std::string toGlb(const Scene& scene, std::span<const int> cameras);

}  // namespace host
