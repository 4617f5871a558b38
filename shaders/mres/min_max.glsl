// One level of the min/max mips of a frame, after Nichols and Wyman, "Multiresolution Splatting for Indirect
// Illumination" (2009): the least and the largest window depth, and normal by component, of a block of pixels.
uniform sampler2D depthRangeTexture;     // least, largest
uniform sampler2D leastNormalTexture;    // as encoded
uniform sampler2D largestNormalTexture;

struct Range {
    vec2 depth;
    vec3 leastNormal, largestNormal;
};

// Of no pixels. What the sky has for normals means nothing: it has none here.
Range emptyRange() {
    return Range(vec2(2.0, -1.0), vec3(2.0), vec3(-2.0));
}

Range fetchRange(ivec2 texel) {
    ivec2 inside = min(texel, textureSize(depthRangeTexture, 0) - 1);
    return Range(texelFetch(depthRangeTexture, inside, 0).rg, texelFetch(leastNormalTexture, inside, 0).rgb,
                 texelFetch(largestNormalTexture, inside, 0).rgb);
}

Range join(Range a, Range b) {
    return Range(vec2(min(a.depth.x, b.depth.x), max(a.depth.y, b.depth.y)), min(a.leastNormal, b.leastNormal),
                 max(a.largestNormal, b.largestNormal));
}
