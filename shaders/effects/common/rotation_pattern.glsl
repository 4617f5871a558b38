// Sixteen azimuths in a 4x4 pattern that the level's filter integrates exactly: a Bayer matrix, so that neighbours differ
// much, and the four of a 2x2 pattern are quarter turns.
const int kBayer[16] = int[16](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);

float azimuthOf(ivec2 noisePixel) {
    int turn = kBayer[(noisePixel.y & 3) * 4 + (noisePixel.x & 3)];
    return float(turn) * (6.28318530718 / 16.0);
}
