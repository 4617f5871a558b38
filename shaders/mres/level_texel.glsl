// A pixel of a level whose texture has it where the level does: value, then filter depth.
uniform sampler2D levelTexture;

vec4 levelTexel(ivec2 levelPixel) { return texelFetch(levelTexture, levelPixel, 0); }
