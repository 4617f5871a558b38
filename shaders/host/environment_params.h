// What reaches the scene from everywhere: the ambient light and the sky behind it.
#pragma once
#include "common/params.h"

BEGIN_PARAMS
UNIFORM_BLOCK(EnvironmentParams) {
  vec4 skyZenith;      // rgb, radiance
  vec4 skyHorizon;     // rgb, radiance
  vec4 skyGround;      // rgb, radiance
  vec4 ambientAbove;   // rgb, ambient radiance that comes from straight above
  vec4 ambientBelow;   // rgb, the same from straight below
};
END_PARAMS
