// Screen-space directional occlusion with one bounce: read by C++ and GLSL.
#pragma once

#include "common/params.h"

#define SSGI_BLOCK_POINTS 1024   // all that the 16 KB of a uniform block hold; the others lie in a texture
#define SSGI_POINTS_PER_ROW 128  // of that texture

BEGIN_PARAMS

UNIFORM_BLOCK(SsgiParams) {
    float radius;            // metres. Reach of the occlusion and of the bounce.
    float bias;              // share of the radius that a surface must rise above the tangent plane to block
    float bounce;            // multiplies what senders send; 0 without a lit picture
    int sampleCount;
    vec4 up;                 // xyz: view space, unit length
    vec4 environmentAbove;   // rgb: radiance that comes from straight above
    vec4 environmentBelow;   // rgb: radiance that comes from straight below
    float radianceScale;     // from the lit picture's values to the environment's unit
    float maxRadiance;       // of a sender, in the environment's unit
    vec2 ssgiPadding;
};

UNIFORM_BLOCK(SsgiPoints) {
    vec4 points[SSGI_BLOCK_POINTS];  // xyz in the unit hemisphere around +Z; w = log2 of its length
};

END_PARAMS
