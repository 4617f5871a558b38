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
    float steeper;   // share of the plane's own slope that `slope` lacks, 0..1
    vec2 perMetre;   // texture coordinates per metre across the light
    float distance;  // w: from a spot light, 1 for parallel light
    float uncertainty;  // metres above the plane by which the rounding of the frame's depth may move the point
    bool facesLight;
    bool inMap;
};

// Where light grazes a surface, its plane soon rises above whatever may block the light: the filter's disk shrinks with the
// slope (the tangent of the angle between light and normal), down to a texel, and for that the slope itself is limited. Where
// the limit takes something away, from 88 degrees on, the disk moves off the surface instead, see offPlane().
const float kSteepestSlope = 4.0;
const float kSteepestTexelSlope = 32.0;

// The plane n . x = const around a point: with J the derivatives of place and depth by the view-space position,
// J_depth = slope.x J_u + slope.y J_v + perRise n, solved by Cramer's rule.
Receiver receiverAt(Surface surface) {
    vec3 position = surface.position, normal = surface.normal;
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
    receiver.steeper = max(1.0 - kSteepestTexelSlope / steepness, 0.0);
    receiver.distance = w;
    receiver.uncertainty = surface.uncertainty;
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

// From the centre of a texel to its corner, 0.71, and a margin.
const float kTexelReach = 0.75;

// How much nearer to the light than a disk's plane whatever blocks must be, in window depth; `reach` is the disk's radius in
// texels.
float depthBias(Receiver receiver, float reach) {
    float metresPerTexel = 1.0 / (receiver.perMetre.x * shadowMapSize.x);
    return (bias * reach * metresPerTexel + receiver.uncertainty) * receiver.perRise;
}

// How far to move a disk across the light, in texels. A plane with slope s that is taken for one with slope c shadows itself
// at a distance r by (s - c) r; moved by m towards where the plane is deeper, off its lit side, it gains s m.
vec2 offPlane(Receiver receiver, vec2 depthFromTexels, float reach) {
    if (receiver.steeper == 0.0) return vec2(0.0);
    return normalize(depthFromTexels) * (receiver.steeper * (reach + kTexelReach));
}

Disk diskAround(Receiver receiver, float radius, float azimuth) {
    vec2 reach = max(radius * receiver.reach * receiver.perMetre * shadowMapSize, vec2(1.0));
    float c = cos(azimuth), s = sin(azimuth);
    Disk disk;
    disk.texelsFromUnit = mat2(c * reach.x, s * reach.y, -s * reach.x, c * reach.y);
    disk.depthFromTexels = receiver.slope / shadowMapSize;
    disk.centre = receiver.place * shadowMapSize + offPlane(receiver, disk.depthFromTexels, max(reach.x, reach.y));
    disk.depth = receiver.depth - depthBias(receiver, reach.x);
    return disk;
}

// Depth of the shadow map at a sample of the disk, less that of the receiver's plane: negative for blockers. Where the map
// shows nothing it is 1, and what the plane has beyond the map's range is not blocked by that.
float heightInMap(Disk disk, vec2 unitSample, out float mapDepth) {
    vec2 texel = floor(clamp(disk.centre + disk.texelsFromUnit * unitSample, vec2(0.0), shadowMapSize - 1.0));
    mapDepth = texelFetch(shadowMap, ivec2(texel), 0).r;
    return mapDepth - min(disk.depth + dot(disk.depthFromTexels, texel + 0.5 - disk.centre), 1.0);
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
        if (height >= 0.0) continue;  // and may be infinitely far from the light
        sum += mapDistance.y == 0.0 ? -height : mapDistance.y / (mapDepth - mapDistance.x);
        count += 1.0;
    }
    if (count == 0.0) return 0.0;
    float mean = sum / count;
    // Similar triangles: parallel light from a cone of directions, or a spot light of a size. The disk's plane is nearer to
    // the light than the receiver by the bias.
    float radius = mapDistance.y == 0.0 ? (mean + receiver.depth - disk.depth) / length(shadowDepth.xyz)
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
    Receiver receiver = receiverAt(surface);
    float visibility;
    if (isDecided(surface, receiver, visibility)) return vec4(visibility);
    float azimuth = azimuthOf(surface.noisePixel);
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
// at all. With PCSS shade()'s disk may be as small as a texel, and its bias with it: then lower rises block as well. (Beyond
// 88 degrees, where it also moves off the plane by less, the bounds are a little too narrow: there is hardly any light.)
vec2 preview(Surface surface) {
    Receiver receiver = receiverAt(surface);
    float visibility;
    if (isDecided(surface, receiver, visibility)) return vec2(visibility);
    Disk disk = diskAround(receiver, filterRadius, azimuthOf(surface.noisePixel));
    float leastDepth = receiver.depth - depthBias(receiver, 1.0);
    float blockingHeight = penumbraScale == 0.0 ? 0.0 : max(leastDepth - disk.depth, 0.0);
    bool someLit = false, someBlocked = false;
    for (int i = 0; i < SOFT_SHADOWS_PREVIEW_SAMPLES; ++i) {
        float mapDepth;
        float height = heightInMap(disk, previewSamples[i].xy, mapDepth);
        someLit = someLit || height >= 0.0;
        someBlocked = someBlocked || height < blockingHeight;
    }
    return vec2(someBlocked ? 0.0 : 1.0, someLit ? 1.0 : 0.0);
}
