#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "host/image/image_file.h"

namespace host {

/// One channel of two images. Where either isn't finite, `a` is 1 and `b` is 0: an error of 1 in every
/// measure.
struct ChannelPair {
  glm::ivec2 size{0};
  std::vector<float> a;
  std::vector<float> b;
};

ChannelPair channelPair(const FloatImage& image, const FloatImage& reference, int channel);

/// Mean SSIM of values in 0..1 (see compareImages).
double structuralSimilarity(const ChannelPair& pair);

}  // namespace host
