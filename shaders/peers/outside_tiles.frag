#version 330 core
// Draws nothing, outside of the tiles that a level renders: what a stencil is made of. Apart from the upsampling there, which
// would be slower with a discard in it.
#include "peers/tile_rate.glsl"

void main() {
    if (isInTileOfThisLevel(ivec2(gl_FragCoord.xy))) discard;
}
