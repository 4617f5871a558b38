#version 330 core
// A coarser level's picture at the pixels of a finer level.
//   JOINT  of the texels on the pixel's own plane, and with filter depth; else bilinear, whatever the texels are of
#include "mres/coarser.glsl"
#include "mres/value.glsl"

out vec4 fragment;

#if JOINT
#include "peers/plane_mean.glsl"

Neighbours coarserNeighbours(vec2 place) {
    Footprint footprint = footprintAt(place);
    Neighbours around;
    around.shares = footprint.shares;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = texelOf(footprint, i);
        around.texels[i] = texelFetch(coarserTexture, texel, 0);
        around.pixels[i] = coarserRepresentativePixel(texel, size);
    }
    return around;
}

vec4 upsampled(ivec2 levelPixel) {
    return texelAmong(coarserNeighbours(placeOf(levelPixel, size)), representativePixel(levelPixel, size));
}
#else
vec4 upsampled(ivec2 levelPixel) {
    return texture(coarserTexture, coarserCoordinate(placeOf(levelPixel, size)));
}
#endif

void main() {
    fragment = upsampled(ivec2(gl_FragCoord.xy));
}
