#pragma once

#include "host/scene/scene.h"

namespace host {

/// A slow way through a scene: from one of its cameras on, forward and turning, in steps as people and games
/// take them at sixty frames a second. A pixel's surface moves by less than one pixel to some pixels a frame.
struct CameraPath {
  int frames = 8;        ///< at least 2
  float metres = 0.01f;  ///< forward in a step; less in scenes of which that would be more than a thousandth
  float degrees = 0.1f;  ///< to the side in a step
};

/// The camera at a frame of the path, counted from 0, which is `camera` itself. In world units alone, so that
/// the path is the same at every size of the picture. It turns round before it is far: however many frames,
/// it stays within eight steps of `camera`.
Camera cameraAt(const Camera& camera, const CameraPath& path, const Bounds& scene, int frame);

}  // namespace host
