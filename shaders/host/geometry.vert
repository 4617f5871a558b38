#version 330 core
// Places a mesh's vertices in the world, relative to the camera.
#include "host/view_params.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec4 objectToWorld0;  // rows of the instance's affine map
layout(location = 5) in vec4 objectToWorld1;
layout(location = 6) in vec4 objectToWorld2;

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec2 texCoord;

vec3 toUnit(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0);
}

void main() {
    worldPosition = vec4(position, 1.0) * mat3x4(objectToWorld0, objectToWorld1, objectToWorld2);
    gl_Position = worldToClip * vec4(worldPosition, 1.0);

    // Normals go by the inverse transpose. The cofactor matrix is that times the determinant, without the division;
    // the determinant's sign tells a mirrored instance, whose cross products point the other way.
    mat3 linear = transpose(mat3(objectToWorld0.xyz, objectToWorld1.xyz, objectToWorld2.xyz));
    mat3 cofactor = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
    float handedness = dot(linear[0], cofactor[0]) < 0.0 ? -1.0 : 1.0;
    worldNormal = toUnit(cofactor * normal) * handedness;
    worldTangent = vec4(toUnit(linear * tangent.xyz), tangent.w * handedness);
    texCoord = uv;
}
