#version 330 core
// Unpacks the checkerboard, and fills its other half from the nearest evaluated pixels to the left, to the right, below and
// above, interpolated along both axes. Before the filter: over a period of the noise every evaluated pixel then counts the
// same, so that the filter's mean is as free of noise as at full resolution.
#include "mres/level.glsl"
#include "mres/level_texel.glsl"
#include "peers/checkerboard.glsl"
#include "peers/plane_mean.glsl"

out vec4 fragment;

// A pixel of a block that is not evaluated: the next blocks are.
Neighbours neighboursOf(ivec2 pixel) {
    ivec2 inBlock = pixel % CHECKERBOARD_BLOCK;
    ivec2 before = pixel - inBlock - 1;
    ivec2 after = pixel - inBlock + CHECKERBOARD_BLOCK;
    vec2 share = 0.5 * vec2(inBlock + 1) / float(CHECKERBOARD_BLOCK + 1);
    vec2 rest = 0.5 - share;

    Neighbours around;
    around.pixels = ivec2[4](ivec2(before.x, pixel.y), ivec2(after.x, pixel.y), ivec2(pixel.x, before.y),
                             ivec2(pixel.x, after.y));
    around.shares = vec4(rest.x, share.x, rest.y, share.y);
    // The first block is evaluated, so that this one has another to the left or below, which stands in off the screen.
    ivec2 inside = before.x >= 0 ? around.pixels[0] : around.pixels[2];
    for (int i = 0; i < 4; ++i) {
        ivec2 other = around.pixels[i];
        bool onScreen = all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, size));
        around.pixels[i] = onScreen ? other : inside;
        around.shares[i] = onScreen ? around.shares[i] : 0.0;
        around.texels[i] = levelTexel(texelOfPixel(around.pixels[i]));
    }
    return around;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (isEvaluated(pixel))
        fragment = levelTexel(texelOfPixel(pixel));
    else
        fragment = texelAmong(neighboursOf(pixel), pixel);
}
