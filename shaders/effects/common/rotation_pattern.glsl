// Sixteen azimuths in a 4x4 pattern that the level's filter integrates exactly: a Bayer matrix, so that neighbours differ
// much.
const int kBayer[16] = int[16](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);

float azimuthOf(ivec2 levelPixel) {
    int turn = kBayer[(levelPixel.y & 3) * 4 + (levelPixel.x & 3)];
    return float(turn) * (6.28318530718 / 16.0);
}
