// What counts as a step in depth: a difference of window depth that is more than rounding and, in metres, more than the
// threshold. The difference of view depth between two window depths is |t1 - t0| depthSlope() / (slopeRoot(t0)
// slopeRoot(t1)).
#include "mres/edges_params.h"
#include "mres/frame.glsl"

// The second difference of three rounded depths is off by two steps at most; rasterisers add as much again.
const float kStepsOfRounding = 4.0;

// A difference of window depth between surfaces whose window depths are from `lowest` to `highest`.
bool isDepthStep(float difference, float lowest, float highest) {
    float slopeRoots = slopeRoot(lowest) * slopeRoot(highest);  // 0 where one is infinitely far
    return difference > kStepsOfRounding * depthRoundingAt(highest) &&
           difference * depthSlope() > depthThreshold * slopeRoots;
}
