#version 330 core
// Chooses the level that renders each tile, by the error that it would leave (content-adaptive shading, Yang et al. 2019,
// "Visually Lossless Content and Motion Adaptive Shading in Games"). Hardware shows coarse values as they are, so that there
// any slope errs; here they are upsampled along planes, so that what errs is what neighbours don't foretell. How much that
// is the quarter level's picture shows: each texel against the mean of the four around it, which is what a level of half
// the resolution would have shown. From there to the quarter level, and on to the half level, errors about halve: each tile
// is left with a quarter of the threshold at most.
#include "mres/level.glsl"
#include "mres/level_texel.glsl"
#include "peers/plane_mean.glsl"
#include "peers/tile_rate.glsl"

uniform float threshold;  // for the RMS over a tile of what a level of an eighth of the resolution would err by

out float fragment;

const int kTexels = ADAPTIVE_TILE / 4;  // of the quarter level, along a tile

const ivec2 kAround[4] = ivec2[4](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

float errorAt(ivec2 texel) {
    vec4 centre = levelTexel(texel);
    if (isBackgroundFilterDepth(FILTER_DEPTH(centre))) return 0.0;
    Neighbours around;
    around.shares = vec4(0.25);
    for (int i = 0; i < 4; ++i) {
        ivec2 other = clamp(texel + kAround[i], ivec2(0), levelSize - 1);
        around.texels[i] = levelTexel(other);
        around.pixels[i] = representativePixel(other, size);
    }
    float viewDepth = viewDepthOfFilter(FILTER_DEPTH(centre));
    return shownDifference(VALUE(centre), meanOnPlane(representativePixel(texel, size), viewDepth, around));
}

// Texels at the border lack a neighbour: those next to them speak for them, where there are any.
ivec2 besideBorder(ivec2 texel) {
    return min(max(texel, ivec2(1)), max(levelSize - 2, ivec2(0)));
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * kTexels;
    float sum = 0.0;
    for (int i = 0; i < kTexels * kTexels; ++i) {
        float error = errorAt(besideBorder(corner + ivec2(i % kTexels, i / kTexels)));
        sum += error * error;
    }
    float rms = sqrt(sum / float(kTexels * kTexels));
    float level = rms > threshold ? 0.0 : rms > 0.5 * threshold ? 1.0 : kCoarsestTileLevel;
    fragment = rateOfLevel(level);
}
