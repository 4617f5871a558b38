// An effect's value as its textures hold it: accessibility or visibility in one channel, radiance in three.
#if EFFECT_CHANNELS == 1
#define Value float
#define VALUE(texel) texel.r
#else
#define Value vec3
#define VALUE(texel) texel.rgb
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
