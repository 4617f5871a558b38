// How far points lie off the plane that touches a pixel's surface.
#include "mres/filter_depth.glsl"
#include "mres/frame.glsl"

// A pixel's tangent plane. How far the point of another pixel lies along the plane's normal is linear in the pixel and in
// the point's depth: depth * (scaled + dot(pixels, scaledStep)) + constant + dot(pixels, constantStep).
struct TangentPlane {
    float scaled;
    vec2 scaledStep;
    float constant;     // zero for perspective cameras, as is the next
    vec2 constantStep;
    float offset;       // of the plane itself
    float inverseTolerance;
};

TangentPlane tangentPlane(ivec2 fullPixel, float viewDepth) {
    vec3 normal = viewNormal(fullPixel);
    vec2 pixel = vec2(fullPixel) + 0.5;
    TangentPlane plane;
    plane.scaled = dot(normal.xy, pixel * unprojectScaled.xy + unprojectScaled.zw) - normal.z;
    plane.scaledStep = normal.xy * unprojectScaled.xy;
    plane.constant = dot(normal.xy, pixel * unprojectConstant.xy + unprojectConstant.zw);
    plane.constantStep = normal.xy * unprojectConstant.xy;
    plane.offset = viewDepth * plane.scaled + plane.constant;
    plane.inverseTolerance = 1.0 / filterToleranceAt(viewDepth);
    return plane;
}

// 0..1: whole up to the tolerance, none from twice the tolerance on, nor where there is no plane (NaN).
float trustIn(TangentPlane plane, vec2 pixels, float viewDepth) {
    float along = viewDepth * (plane.scaled + dot(pixels, plane.scaledStep)) +
                  (plane.constant + dot(pixels, plane.constantStep));
    float tolerances = abs(along - plane.offset) * plane.inverseTolerance;
    return tolerances < 2.0 ? min(2.0 - tolerances, 1.0) : 0.0;
}
