// Ambient occlusion by points in the hemisphere over each pixel's surface (after Mittring 2007, with the
// normal-oriented hemisphere of later engines): a point occludes if the depth buffer shows a surface in front of
// it, within reach, that rises above the tangent plane. Returns accessibility, 0..1.
#include "effects/ssao_params.h"

uniform sampler2D depthPyramid;  // view depth; texel t of mip m is that of full-resolution pixel t * 2^m + 2^m / 2

// The azimuth of the kernel steps through sixteen values in a 4x4 pattern (a 4x4 Bayer matrix, so that neighbours
// differ much), which the level's filter integrates exactly.
const int kBayer[16] = int[16](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
// log2 of the distance in pixels up to which samples read the full resolution; farther ones read a mip whose texels
// are an eighth of their distance.
const float kFullResolutionReach = 3.0;

const float kAzimuthStep = 6.28318530718 / 16.0;

// Any two axes perpendicular to a unit normal (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
void tangentFrame(vec3 normal, out vec3 tangent, out vec3 bitangent) {
    float s = normal.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + normal.z);
    float b = normal.x * normal.y * a;
    tangent = vec3(1.0 + s * normal.x * normal.x * a, s * b, -s * normal.x);
    bitangent = vec3(b, s + normal.y * normal.y * a, -normal.y);
}

// Pixel coordinates times clip w, clip w, and view depth, of a view-space direction (the linear part).
vec4 projectDirection(vec3 direction) {
    return vec4(dot(pixelX.xyz, direction), dot(pixelY.xyz, direction), dot(clipW.xyz, direction), -direction.z);
}

vec4 shade(Surface surface) {
    int turn = kBayer[(surface.levelPixel.y & 3) * 4 + (surface.levelPixel.x & 3)];
    float azimuth = float(turn) * kAzimuthStep;
    vec3 tangent, bitangent;
    tangentFrame(surface.normal, tangent, bitangent);
    vec3 axisX = cos(azimuth) * tangent + sin(azimuth) * bitangent;
    vec3 axisY = cos(azimuth) * bitangent - sin(azimuth) * tangent;

    // A sample's projection is linear in its coordinates: project the axes once, not every sample.
    vec4 clipX = projectDirection(axisX) * radius;
    vec4 clipY = projectDirection(axisY) * radius;
    vec4 clipZ = projectDirection(surface.normal) * radius;
    vec4 clipOrigin = projectDirection(surface.position) + vec4(pixelX.w, pixelY.w, clipW.w, 0.0);

    float mipOfRadius = log2(radius * pixelsPerMetre / clipOrigin.z) - kFullResolutionReach;
    float fade = 1.0 / (3.0 * radius * radius);
    float rise = radius * bias;
    float lastMip = float(pyramidLevels - 1);
    vec2 lastPixel = vec2(size) - 0.5;

    float occlusion = 0.0;
    int count = surface.background ? 0 : sampleCount;
    for (int i = 0; i < count; ++i) {
        vec4 point = samples[i];
        vec4 projected = clipOrigin + clipX * point.x + clipY * point.y + clipZ * point.z;
        int mip = int(clamp(mipOfRadius + point.w, 0.0, lastMip));
        ivec2 pixel = ivec2(clamp(projected.xy / projected.z, vec2(0.0), lastPixel));
        ivec2 texel = min(pixel >> mip, (size >> mip) - 1);
        float depth = texelFetch(depthPyramid, texel, mip).r;
        vec2 seen = vec2((texel << mip) + ((1 << mip) >> 1)) + 0.5;
        vec3 toSurface = unproject(seen, depth) - surface.position;
        float distance2 = dot(toSurface, toSurface);
        bool inFront = depth < projected.w && dot(toSurface, surface.normal) > rise;
        // Surfaces beyond the radius fade out over a second radius: what lies behind them is unknown.
        float nearness = clamp(4.0 / 3.0 - distance2 * fade, 0.0, 1.0);
        occlusion += inFront ? nearness : 0.0;
    }
    float mean = occlusion / float(max(count, 1));
    return vec4(clamp(1.0 - intensity * mean, 0.0, 1.0));
}
