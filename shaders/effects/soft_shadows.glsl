// Soft shadows from one shadow map: percentage-closer filtering (Reeves, Salesin and Cook 1987) with a disk of samples,
// and percentage-closer soft shadows (Fernando 2005), which find the disk's radius from the blockers in it. Returns
// visibility of the light, 0..1.
//
// On the plane through the receiver, window depth of the shadow map is affine in its texture coordinates, for parallel
// light and spot lights alike. So every texel is compared with what the receiver's plane has at that texel's own centre
// (receiver plane depth bias, Isidoro 2006): a plane never shadows itself, however large the disk.
#include "effects/common/rotation_pattern.glsl"
#include "effects/soft_shadows_params.h"
#include "mres/surface.glsl"

uniform sampler2D shadowMap;

struct Receiver {
    vec2 place;      // texture coordinates in the shadow map
    float depth;     // window depth there
    vec2 slope;      // d depth / d place on the receiver's plane
    float perRise;   // window depth per metre above the plane
    float reach;     // share of the filter's radius that the plane's slope allows
    vec2 perMetre;   // texture coordinates per metre across the light
    float distance;  // w: from a spot light, 1 for parallel light
    bool facesLight;
    bool inMap;
};

// Where light grazes a surface, its plane soon rises above whatever may block the light: the filter's disk shrinks with the
// slope (the tangent of the angle between light and normal), down to a texel, and for that the slope itself is limited.
const float kSteepestSlope = 4.0;
const float kSteepestTexelSlope = 32.0;

// The plane n . x = const around a point: with J the derivatives of place and depth by the view-space position,
// J_depth = slope.x J_u + slope.y J_v + perRise n, solved by Cramer's rule.
Receiver receiverAt(vec3 position, vec3 normal) {
    vec4 point = vec4(position, 1.0);
    float w = dot(shadowW, point);
    vec3 window = vec3(dot(shadowU, point), dot(shadowV, point), dot(shadowDepth, point)) / w;
    vec3 byU = (shadowU.xyz - window.x * shadowW.xyz) / w;
    vec3 byV = (shadowV.xyz - window.y * shadowW.xyz) / w;
    vec3 byDepth = (shadowDepth.xyz - window.z * shadowW.xyz) / w;
    vec3 across = cross(byU, byV);
    float determinant = dot(across, normal);

    Receiver receiver;
    receiver.place = window.xy;
    receiver.depth = window.z;
    receiver.slope = vec2(dot(cross(byDepth, byV), normal), dot(cross(byU, byDepth), normal)) / determinant;
    receiver.perRise = abs(dot(across, byDepth) / determinant);
    receiver.perMetre = vec2(length(byU), length(byV));
    float steepness = length(receiver.slope * receiver.perMetre) / length(byDepth);
    receiver.reach = min(kSteepestSlope / steepness, 1.0);
    receiver.slope *= min(kSteepestTexelSlope / steepness, 1.0);
    receiver.distance = w;
    vec3 toLight = light.w == 0.0 ? light.xyz : light.xyz - position;
    receiver.facesLight = dot(toLight, normal) > 0.0;
    receiver.inMap = w > 0.0 && all(greaterThanEqual(window, vec3(0.0))) && all(lessThanEqual(window, vec3(1.0)));
    return receiver;
}

// A disk of samples around a receiver, in texels.
struct Disk {
    vec2 centre;
    mat2 texelsFromUnit;
    vec2 depthFromTexels;  // slope per texel
    float depth;           // of the plane at the centre, less the bias
};

Disk diskAround(Receiver receiver, float radius, float azimuth) {
    vec2 reach = max(radius * receiver.reach * receiver.perMetre * shadowMapSize, vec2(1.0));
    float c = cos(azimuth), s = sin(azimuth);
    Disk disk;
    disk.centre = receiver.place * shadowMapSize;
    disk.texelsFromUnit = mat2(c * reach.x, s * reach.y, -s * reach.x, c * reach.y);
    disk.depthFromTexels = receiver.slope / shadowMapSize;
    disk.depth = receiver.depth - bias * reach.x / (receiver.perMetre.x * shadowMapSize.x) * receiver.perRise;
    return disk;
}

// Depth of the shadow map at a sample of the disk, less that of the receiver's plane: negative for blockers.
float heightInMap(Disk disk, vec2 unitSample, out float mapDepth) {
    vec2 texel = floor(clamp(disk.centre + disk.texelsFromUnit * unitSample, vec2(0.0), shadowMapSize - 1.0));
    mapDepth = texelFetch(shadowMap, ivec2(texel), 0).r;
    return mapDepth - (disk.depth + dot(disk.depthFromTexels, texel + 0.5 - disk.centre));
}

bool isLit(Disk disk, vec2 unitSample) {
    float mapDepth;
    return heightInMap(disk, unitSample, mapDepth) >= 0.0;
}

// Radius of the penumbra in metres, from the mean distance of the blockers around; 0 where there are none.
float penumbraRadius(Receiver receiver, float azimuth) {
    Disk disk = diskAround(receiver, filterRadius, azimuth);
    float sum = 0.0, count = 0.0;
    for (int i = 0; i < SOFT_SHADOWS_BLOCKER_SAMPLES; ++i) {
        float mapDepth;
        float height = heightInMap(disk, blockerSamples[i].xy, mapDepth);
        float blocks = height < 0.0 ? 1.0 : 0.0;
        sum += blocks * (mapDistance.y == 0.0 ? -height : mapDistance.y / (mapDepth - mapDistance.x));
        count += blocks;
    }
    if (count == 0.0) return 0.0;
    float mean = sum / count;
    // Similar triangles: parallel light from a cone of directions, or a spot light of a size.
    float radius = mapDistance.y == 0.0 ? mean / length(shadowDepth.xyz)
                                        : max(receiver.distance - mean, 0.0) / mean;
    return min(radius * penumbraScale, filterRadius);
}

// Where no sample is needed: 0 behind the surface's back, 1 where nothing is known of shadows.
bool isDecided(Surface surface, Receiver receiver, out float visibility) {
    bool open = surface.background || shadowMapSize.x == 0.0;
    visibility = open || receiver.facesLight ? 1.0 : 0.0;
    return open || !receiver.facesLight || !receiver.inMap;
}

vec4 shade(Surface surface) {
    Receiver receiver = receiverAt(surface.position, surface.normal);
    float visibility;
    if (isDecided(surface, receiver, visibility)) return vec4(visibility);
    float azimuth = azimuthOf(surface.levelPixel);
    float radius = penumbraScale == 0.0 ? filterRadius : penumbraRadius(receiver, azimuth);
    Disk disk = diskAround(receiver, radius, azimuth);
    int lit = 0;
    for (int i = 0; i < sampleCount; i += 2) {
        vec4 pair = samples[i >> 1];
        if (isLit(disk, pair.xy)) ++lit;
        if (i + 1 < sampleCount && isLit(disk, pair.zw)) ++lit;
    }
    return vec4(float(lit) / float(sampleCount));
}

// The least and the largest value that shade() may have here, by few samples: equal where the light is seen wholly or not
// at all.
vec2 preview(Surface surface) {
    Receiver receiver = receiverAt(surface.position, surface.normal);
    float visibility;
    if (isDecided(surface, receiver, visibility)) return vec2(visibility);
    Disk disk = diskAround(receiver, filterRadius, azimuthOf(surface.levelPixel));
    int lit = 0;
    for (int i = 0; i < SOFT_SHADOWS_PREVIEW_SAMPLES; ++i) {
        if (isLit(disk, previewSamples[i].xy)) ++lit;
    }
    return vec2(lit == SOFT_SHADOWS_PREVIEW_SAMPLES ? 1.0 : 0.0, lit == 0 ? 0.0 : 1.0);
}
