// The depth that a level keeps beside its values for the filter, as a half float.
#include "mres/frame_params.h"

const float kLargestHalf = 65504.0;

// Farther than every surface, so that the filter never mixes sky and surface.
const float kBackgroundFilterDepth = kLargestHalf;

float filterDepthOf(float viewDepth) {
    return min(viewDepth * filterDepth.x + filterDepth.y, 0.5 * kBackgroundFilterDepth);
}

float viewDepthOfFilter(float filterDepthValue) {
    return (filterDepthValue - filterDepth.y) / filterDepth.x;
}

bool isBackgroundFilterDepth(float filterDepthValue) {
    return filterDepthValue > 0.75 * kBackgroundFilterDepth;
}

float filterToleranceAt(float viewDepth) {
    return viewDepth * filterTolerance.x + filterTolerance.y;
}
