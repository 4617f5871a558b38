#include "host/measure/block_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/measure/statistics.h"
#include "host/measure/value_error.h"

namespace host {
namespace {

constexpr int kBlock = 8;

struct BlockSum {
  double squares = 0.0;
  int values = 0;
};

glm::ivec2 blocksOf(glm::ivec2 size) {
  return (size + kBlock - 1) / kBlock;
}

double rmsOf(const BlockSum& block) {
  return std::sqrt(block.squares / block.values);
}

std::vector<BlockSum> sumBlocks(const FloatImage& image, const FloatImage& reference, glm::ivec2 blocks) {
  std::vector<BlockSum> sums(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y));
  std::size_t i = 0;
  for (int y = 0; y < image.size.y; ++y) {
    for (int x = 0; x < image.size.x; ++x) {
      BlockSum& sum = sums[static_cast<std::size_t>(y / kBlock * blocks.x + x / kBlock)];
      for (int channel = 0; channel < image.channels; ++channel, ++i) {
        const double error = absoluteError(image.pixels[i], reference.pixels[i]);
        sum.squares += error * error;
        ++sum.values;
      }
    }
  }
  return sums;
}

}  // namespace

std::vector<double> blockErrors(const FloatImage& image, const FloatImage& reference) {
  std::vector<double> errors;
  for (const BlockSum& sum : sumBlocks(image, reference, blocksOf(image.size))) errors.push_back(rmsOf(sum));
  return errors;
}

BlockErrors compareBlocks(const FloatImage& image, const FloatImage& reference) {
  const std::vector<double> errors = blockErrors(image, reference);
  const auto worst = std::ranges::max_element(errors);
  const auto index = static_cast<int>(worst - errors.begin());
  const int columns = blocksOf(image.size).x;
  const glm::ivec2 corner = kBlock * glm::ivec2(index % columns, index / columns);
  return {.max = *worst,
          .percentile99 = quantile(errors, 0.99),
          .worst = glm::min(corner + kBlock / 2, image.size - 1)};
}

}  // namespace host
