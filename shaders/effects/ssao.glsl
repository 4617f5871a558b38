// Ambient occlusion by points in the hemisphere over each pixel's surface (after Mittring 2007, with the
// normal-oriented hemisphere of later engines): a point occludes if the depth buffer shows a surface in front of
// it, within reach, that rises above the tangent plane. Returns accessibility, 0..1.
#include "effects/common/hemisphere.glsl"
#include "effects/ssao_params.h"

vec4 shade(Surface surface) {
    Hemisphere over = hemisphereOver(surface, radius, bias);
    float occlusion = 0.0;
    int count = surface.background ? 0 : sampleCount;
    for (int i = 0; i < count; ++i) occlusion += lookAt(samples[i], over).blocked;
    float mean = occlusion / float(max(count, 1));
    return vec4(clamp(1.0 - intensity * mean, 0.0, 1.0));
}
