// Shadows by the host itself: percentage-closer filtering (Reeves et al. 1987) with a tent of 5 x 5 texels.
#include "host/shadow_params.h"

uniform sampler2DShadow shadowMap;

// The tent reaches three texels from its centre.
const float kNormalOffsetTexels = 3.0;

// A tent over five texels of one axis, as three bilinear taps (after Castano 2013, "Shadow mapping summary"): the
// hardware's own filter weighs the two texels of a tap. `fraction` is where in its texel the centre lies, 0..1.
void tentTaps(float fraction, out vec3 offsets, out vec3 weights) {
    weights = vec3(4.0 - 3.0 * fraction, 7.0, 1.0 + 3.0 * fraction);
    offsets = vec3((3.0 - 2.0 * fraction) / weights.x - 2.0, (3.0 + fraction) / weights.y,
                   fraction / weights.z + 2.0);
    weights /= 12.0;
}

// 1 where the light is seen, 0 in shadow. `normal` is the geometric one, `toLight` has unit length.
float shadowMapVisibility(vec3 position, vec3 normal, vec3 toLight) {
    // Moving the point along its normal keeps a surface from shadowing itself (Holbert 2011, "Saving shadows"). At a
    // distance r across the light a plane is r tan(angle) nearer to it; a shift s along the normal brings the point
    // s / cos(angle) nearer; so s = r sin(angle) is just enough for a filter that reaches r.
    float cosine = dot(normal, toLight);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float texelMetres = shadowTexelMetres * (worldToShadow * vec4(position, 1.0)).w;
    vec4 shifted = worldToShadow * vec4(position + normal * (kNormalOffsetTexels * texelMetres * sine), 1.0);
    if (shifted.w <= 0.0) return 1.0;  // behind a spot light
    vec3 place = shifted.xyz / shifted.w;
    if (any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(1.0)))) return 1.0;

    vec2 texel = place.xy / shadowTexel - 0.5;
    vec2 base = (floor(texel) + 0.5) * shadowTexel;
    vec3 offsetsX, offsetsY, weightsX, weightsY;
    tentTaps(fract(texel.x), offsetsX, weightsX);
    tentTaps(fract(texel.y), offsetsY, weightsY);
    float lit = 0.0;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            vec2 uv = base + vec2(offsetsX[x], offsetsY[y]) * shadowTexel;
            lit += weightsX[x] * weightsY[y] * texture(shadowMap, vec3(uv, place.z));
        }
    }
    return lit;
}
