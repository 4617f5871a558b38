// The camera of a pass. Positions in the renderer's shaders have world axes but the camera as their origin, so that
// scenes far from the world's origin keep their precision.
#pragma once
#include "common/params.h"

BEGIN_PARAMS
UNIFORM_BLOCK(ViewParams) {
  mat4 worldToClip;
  mat4 clipToWorld;
  vec4 eye;  // the viewer is seen from p in direction eye.xyz - eye.w * p; w is 0 for orthographic cameras
};
END_PARAMS
