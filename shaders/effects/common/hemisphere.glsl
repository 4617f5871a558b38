// What effects share that look around with points in the normal-oriented hemisphere over a surface: where the points
// lie on the screen, and whether the depth buffer shows a surface in front of one.
#include "effects/common/rotation_pattern.glsl"
#include "mres/surface.glsl"

uniform sampler2D depthPyramid;  // view depth; texel t of mip m is that of full-resolution pixel t * 2^m + 2^m / 2

// log2 of the distance in pixels up to which samples read the full resolution; farther ones read a mip whose texels
// are an eighth of their distance.
const float kFullResolutionReach = 3.0;

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

struct Hemisphere {
    vec3 origin;                           // view space, metres
    vec3 axisX, axisY, axisZ;              // of the points, unit length; axisZ is the surface's normal
    vec4 clipOrigin, clipX, clipY, clipZ;  // projections of the origin and of axes as long as the radius
    float mipOfRadius;                     // the mip to read at the radius, unbounded
    float fade;                            // 1 / (3 radius^2)
    float rise;                            // metres over the tangent plane up to which nothing blocks
    float lastMip;
    vec2 lastPixel;
};

Hemisphere hemisphereOver(Surface surface, float radius, float bias) {
    float azimuth = azimuthOf(surface.noisePixel);
    vec3 tangent, bitangent;
    tangentFrame(surface.normal, tangent, bitangent);
    Hemisphere over;
    over.origin = surface.position;
    over.axisX = cos(azimuth) * tangent + sin(azimuth) * bitangent;
    over.axisY = cos(azimuth) * bitangent - sin(azimuth) * tangent;
    over.axisZ = surface.normal;

    // A point's projection is linear in its coordinates: project the axes once, not every point.
    over.clipOrigin = projectDirection(surface.position) + vec4(pixelX.w, pixelY.w, clipW.w, 0.0);
    over.clipX = projectDirection(over.axisX) * radius;
    over.clipY = projectDirection(over.axisY) * radius;
    over.clipZ = projectDirection(over.axisZ) * radius;

    over.mipOfRadius = log2(radius * pixelsPerMetre / over.clipOrigin.z) - kFullResolutionReach;
    over.fade = 1.0 / (3.0 * radius * radius);
    over.rise = radius * bias + surface.uncertainty;
    over.lastMip = float(pyramidLevels - 1);
    over.lastPixel = vec2(size) - 0.5;
    return over;
}

// What the depth buffer shows where a point of the hemisphere is.
struct Sight {
    int mip;         // of the depth pyramid
    ivec2 texel;     // of that mip
    ivec2 pixel;     // of the full resolution: the one whose depth the texel holds
    vec3 toSurface;  // from the hemisphere's origin, metres
    float blocked;   // 0..1: whether the surface hides the point
};

// `point`: xyz in the unit hemisphere around +Z; w = log2 of its length.
Sight lookAt(vec4 point, Hemisphere over) {
    vec4 projected = over.clipOrigin + over.clipX * point.x + over.clipY * point.y + over.clipZ * point.z;
    ivec2 pixel = ivec2(clamp(projected.xy / projected.z, vec2(0.0), over.lastPixel));
    Sight sight;
    sight.mip = int(clamp(over.mipOfRadius + point.w, 0.0, over.lastMip));
    sight.texel = min(pixel >> sight.mip, (size >> sight.mip) - 1);
    sight.pixel = (sight.texel << sight.mip) + ((1 << sight.mip) >> 1);
    float depth = texelFetch(depthPyramid, sight.texel, sight.mip).r;
    sight.toSurface = unproject(vec2(sight.pixel) + 0.5, depth) - over.origin;
    float distance2 = dot(sight.toSurface, sight.toSurface);
    bool inFront = depth < projected.w && dot(sight.toSurface, over.axisZ) > over.rise;
    // Surfaces beyond the radius fade out over a second radius: what lies behind them is unknown.
    float nearness = clamp(4.0 / 3.0 - distance2 * over.fade, 0.0, 1.0);
    sight.blocked = inFront ? nearness : 0.0;
    return sight;
}
