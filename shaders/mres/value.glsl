// An effect's value as its textures hold it: accessibility or visibility in one channel, radiance in three. The filter's
// depth (mres/filter_depth.glsl) comes next, in the textures that have it.
#if EFFECT_CHANNELS == 1
#define Value float
#define VALUE(texel) texel.r
#define FILTER_DEPTH(texel) texel.g
#else
#define Value vec3
#define VALUE(texel) texel.rgb
#define FILTER_DEPTH(texel) texel.a
#endif

// How much the difference of two values shows.
#if EFFECT_CHANNELS == 1
float shownDifference(float a, float b) { return abs(a - b); }
#else
const float kDarkestRadiance = 0.05;

float largest(vec3 v) { return max(v.r, max(v.g, v.b)); }

// Michelson's contrast: of radiances the eye sees the ratio; in the dark there is little to see.
float shownDifference(vec3 a, vec3 b) {
    return largest(abs(a - b)) / max(largest(a + b), 2.0 * kDarkestRadiance);
}
#endif
