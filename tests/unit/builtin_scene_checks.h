// What holds for every built-in scene, as expectations.
#pragma once

#include "host/scene/scene.h"

namespace host::test {

/// Meshes have unit normals, valid indices and no degenerate triangles; instances, materials and textures
/// refer to what exists.
void expectSound(const Scene& scene);

/// Eight cameras of different names and places inside the scene's bounds, clear of all surfaces.
void expectEightCameras(const Scene& scene);

/// The same meshes, instances and images, bit for bit.
void expectSame(const Scene& a, const Scene& b);

}  // namespace host::test
