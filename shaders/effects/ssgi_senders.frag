#version 330 core
// What surfaces send in SSGI: the lit picture, made safe and averaged, at half the resolution and its mips. A texel of
// level l is, as one of mip l + 1 of the depth pyramid, a block of 2^(l + 1) x 2^(l + 1) pixels. It goes with the depth and
// the normal of one of them, so only surfaces that face alike count: else a floor would, by way of the foot of a wall, be
// lit by itself; where its own pixel is sky, all surfaces count. FROM_PICTURE: level 0; each other level averages the one before.
#include "effects/ssgi_params.h"
#include "mres/frame.glsl"

uniform sampler2D source;  // the lit picture, or the levels before
uniform int level;

out vec4 fragment;  // rgb: radiance; a: 1 where the texel's own pixel shows a surface, else 0

// Cosine of the angle up to which surfaces face alike.
const float kAlike = 0.5;

bool isSurface(ivec2 pixel) { return texelFetch(depthTexture, pixel, 0).r != backgroundDepth; }

#if FROM_PICTURE
const float kLargestFloat = 3.402823466e38;

// The lit picture is the host's and may hold anything: what is no number, infinite or negative sends nothing.
vec3 sanitised(vec3 radiance) {
    vec3 bounded = clamp(radiance * radianceScale, 0.0, maxRadiance);
    return mix(vec3(0.0), bounded, lessThanEqual(abs(radiance), vec3(kLargestFloat)));
}

vec4 partAt(ivec2 pixel) {
    return isSurface(pixel) ? vec4(sanitised(texelFetch(source, pixel, 0).rgb), 1.0) : vec4(0.0);
}
#else
vec4 partAt(ivec2 texel) { return texelFetch(source, texel, level - 1); }
#endif

// The pixel that a texel of the depth pyramid has its depth of. Mip 1 is larger here than there where the size is odd.
ivec2 ownPixel(ivec2 texel, int mip) { return min((texel << mip) + ((1 << mip) >> 1), size - 1); }

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 pixel = ownPixel(texel, level + 1);
    bool own = isSurface(pixel);
    vec3 normal = viewNormal(pixel);
    ivec2 lastPart = textureSize(source, max(level - 1, 0)) - 1;
    vec4 part = vec4(0.0);
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 place = min(2 * texel + ivec2(i & 1, i >> 1), lastPart);
        part = partAt(place);
        bool counts = part.a > 0.0 && (!own || dot(viewNormal(ownPixel(place, level)), normal) > kAlike);
        sum += counts ? part.rgb : vec3(0.0);
        count += counts ? 1.0 : 0.0;
    }
    // The last part has the texel's own pixel; it stands for a surface too thin to be met anywhere else.
    fragment = vec4(count > 0.0 ? sum / count : part.rgb, own ? 1.0 : 0.0);
}
