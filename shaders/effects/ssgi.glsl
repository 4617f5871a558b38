// Directional occlusion and one bounce of indirect light (Ritschel, Grosch and Seidel 2009, "Approximating Dynamic
// Global Illumination in Image Space"): each point in the hemisphere over a pixel's surface stands for a direction.
// Where the depth buffer shows a surface in front of the point, that surface sends its lit radiance; otherwise the
// environment's arrives. Returns the mean, which is irradiance / pi, since the directions are cosine-weighted.
//
// The paper's bounce adds a patch of area A by its form factor, A cos(sender) cos(receiver) / d^2. But A cos(sender) /
// d^2 is the solid angle of the patch, and each of our N points already stands for the share of the hemisphere that
// its direction does: what is seen counts 1/N, cos(receiver) lies in the density of the directions, and cos(sender)
// only decides whether the sender faces us. So no distance is divided by, nothing is brighter than the brightest that
// is seen, and where all radiance is 1 the result is at most 1.
//
// A point far from the pixel reads a mip of depth, a texel of which has the place and the normal of a single pixel. What
// is sent is about the mean over the pixels of the texel that face as that one does (see ssgi_senders.frag), so that a
// highlight of one pixel counts neither a thousandfold nor, mostly, not at all.
#include "effects/common/hemisphere.glsl"
#include "effects/ssgi_params.h"

uniform sampler2D morePoints;  // those that `points` does not hold
uniform sampler2D senders;     // mean radiance; level l goes with mip l + 1 of depth

// Whether the surface that is seen shows its front to the hemisphere's origin. For that its normal needs neither unit length
// nor to be turned into view space.
bool faces(Sight sender) {
    vec3 normal = texelFetch(normalTexture, sender.pixel, 0).xyz * normalDecode.x + normalDecode.y;
    return dot(normal, sender.toSurface * mat3(viewFromNormals)) < 0.0;
}

// What it sends there. The nearest senders, at the full resolution, share a texel of half the resolution.
vec3 sentBy(Sight sender) {
    ivec2 texel = sender.mip == 0 ? sender.texel >> 1 : sender.texel;
    return faces(sender) ? texelFetch(senders, texel, max(sender.mip - 1, 0)).rgb : vec3(0.0);
}

// Sums over the points of a hemisphere.
struct Arrived {
    vec3 sent;
    float open;    // points that nothing hides
    float height;  // of their directions: the vertical components, in which the environment is linear
};

void addPoint(vec4 point, Hemisphere over, vec3 upOnAxes, inout Arrived arrived) {
    Sight sight = lookAt(point, over);
    if (sight.blocked > 0.0 && bounce > 0.0) arrived.sent += sight.blocked * sentBy(sight);
    float open = 1.0 - sight.blocked;
    arrived.open += open;
    arrived.height += open * dot(upOnAxes, point.xyz) * inversesqrt(dot(point.xyz, point.xyz));
}

vec4 shade(Surface surface) {
    Hemisphere over = hemisphereOver(surface, radius, bias);
    vec3 upOnAxes = vec3(dot(up.xyz, over.axisX), dot(up.xyz, over.axisY), dot(up.xyz, over.axisZ));
    Arrived arrived = Arrived(vec3(0.0), 0.0, 0.0);
    int count = surface.background ? 0 : sampleCount;
    int inBlock = min(count, SSGI_BLOCK_POINTS);
    for (int i = 0; i < inBlock; ++i) addPoint(points[i], over, upOnAxes, arrived);
    for (int i = 0; i < count - inBlock; ++i) {
        ivec2 texel = ivec2(i % SSGI_POINTS_PER_ROW, i / SSGI_POINTS_PER_ROW);
        addPoint(texelFetch(morePoints, texel, 0), over, upOnAxes, arrived);
    }
    vec3 halfRise = 0.5 * (environmentAbove.rgb - environmentBelow.rgb);
    vec3 environment = environmentBelow.rgb * arrived.open + halfRise * (arrived.open + arrived.height);
    return vec4((arrived.sent * bounce + environment) / float(max(count, 1)), 1.0);
}
