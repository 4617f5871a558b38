// What an effect's shade() is given, and what it may call.
#include "mres/frame.glsl"
#include "mres/level.glsl"

struct Surface {
    vec3 position;     // view space, metres
    vec3 normal;       // view space, unit length
    float depth;       // view depth, metres
    float uncertainty;  // metres along the normal by which the depth texture's rounding may move the surface
    vec2 pixel;        // full-resolution pixel coordinates, centres at + 0.5
    ivec2 levelPixel;  // the level's own pixel
    ivec2 noisePixel;  // where in the repeating pattern it lies, 0..noisePeriod - 1: what is random depends on this alone
    bool background;   // no surface here: what shade() returns is replaced
};

Surface fetchSurface(ivec2 levelPixel) {
    ivec2 fullPixel = representativePixel(levelPixel, size);
    float windowDepth = texelFetch(depthTexture, fullPixel, 0).r;
    Surface surface;
    surface.background = windowDepth == backgroundDepth;
    surface.pixel = vec2(fullPixel) + 0.5;
    surface.levelPixel = levelPixel;
    surface.noisePixel = levelPixel % noisePeriod;
    surface.depth = viewDepthOf(windowDepth);
    surface.position = unproject(surface.pixel, surface.depth);
    surface.normal = viewNormal(fullPixel);
    surface.uncertainty = viewDepthRoundingAt(windowDepth) * abs(dot(surface.normal, perViewDepth(surface.pixel)));
    return surface;
}
