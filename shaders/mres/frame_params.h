// The camera and the conventions of one frame: read by C++ and GLSL.
#pragma once
#include "common/params.h"

BEGIN_PARAMS

UNIFORM_BLOCK(FrameParams) {
    mat4 viewFromNormals;    // rotates the normal texture's space into view space
    vec4 pixelX;             // dot with (view position, 1): pixel x times clip w
    vec4 pixelY;             // dot with (view position, 1): pixel y times clip w
    vec4 clipW;              // dot with (view position, 1): clip w
    vec4 unprojectScaled;    // view xy = depth * (pixel * .xy + .zw) + (pixel * constant.xy + constant.zw)
    vec4 unprojectConstant;  // zero for perspective cameras
    vec4 linearise;          // view depth = (.x + .y * window depth) / (.z + .w * window depth)
    vec2 normalDecode;       // normal = texel * .x + .y
    ivec2 size;              // pixels, full resolution
    vec2 filterDepth;        // filter depth = view depth * .x + .y: positive, in the range of half floats
    vec2 filterTolerance;    // distance off its plane at which the filter still trusts a neighbour = view depth * .x + .y
    vec2 depthRounding;      // a step of the depth texture's format = .x + .y * window depth
    float backgroundDepth;   // window depth of the far plane
    float pixelsPerMetre;    // where clip w is 1
    int pyramidLevels;       // mips of the depth pyramid
    float framePadding0;
    float framePadding1;
    float framePadding2;
};

END_PARAMS
