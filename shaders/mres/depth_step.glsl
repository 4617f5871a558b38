// What counts as a step in depth: a difference of window depth that is more than rounding and, in metres, more than the
// threshold. The difference of view depth between two window depths is |t1 - t0| depthSlope.x / (slopeRoot(t0)
// slopeRoot(t1)).
#include "mres/edges_params.h"

float slopeRoot(float windowDepth) {
    return abs(depthSlope.y + depthSlope.z * windowDepth);
}

// A difference of window depth between surfaces whose window depths are from `lowest` to `highest`.
bool isDepthStep(float difference, float lowest, float highest) {
    float slopeRoots = slopeRoot(lowest) * slopeRoot(highest);  // 0 where one is infinitely far
    return difference > depthRounding.x + depthRounding.y * highest &&
           difference * depthSlope.x > depthThreshold * slopeRoots;
}
