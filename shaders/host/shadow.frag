#version 330 core
// Depth alone; alpha-masked materials leave their holes open.
#include "host/material.glsl"

in vec2 texCoord;

void main() {
    if (baseColorAt(texCoord).a < alphaCutoff) discard;
}
