// Which pixels of a level a finer one renders in its stead. Needs the frame's block.

bool isInZone(sampler2D zone, ivec2 block) {
    return texelFetch(zone, block, 0).r > 0.0;
}

// Whether a finer level's zone covers a pixel of a coarser level whole. The pixel is at most eight of the finer level's
// wide, so it lies in two blocks of the zone along an axis at most, and those at its corners are all.
bool isCovered(sampler2D finerZone, int finerStride, ivec2 pixel, int stride) {
    int block = finerStride * ZONE_BLOCK;
    ivec2 low = pixel * stride / block;
    ivec2 high = (min((pixel + 1) * stride, size) - 1) / block;
    return isInZone(finerZone, low) && isInZone(finerZone, high) && isInZone(finerZone, ivec2(low.x, high.y)) &&
           isInZone(finerZone, ivec2(high.x, low.y));
}
