#include "host/measure/error_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "host/measure/structural_similarity.h"
#include "host/measure/value_error.h"

namespace host {
namespace {

void requireSameShape(const FloatImage& image, const FloatImage& reference) {
  if (image.size != reference.size || image.channels != reference.channels ||
      image.pixels.size() != reference.pixels.size() || image.pixels.empty())
    throw std::invalid_argument("only images of the same size and channels, with pixels, can be compared");
}

double meanStructuralSimilarity(const FloatImage& image, const FloatImage& reference) {
  double sum = 0.0;
  for (int channel = 0; channel < image.channels; ++channel)
    sum += structuralSimilarity(channelPair(image, reference, channel));
  return sum / image.channels;
}

}  // namespace

ValueErrors compareValues(const FloatImage& image, const FloatImage& reference) {
  requireSameShape(image, reference);
  ValueErrors errors;
  double squares = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double error = absoluteError(image.pixels[i], reference.pixels[i]);
    squares += error * error;
    errors.max = std::max(errors.max, error);
    if (!areFinite(image.pixels[i], reference.pixels[i])) ++errors.nonFinite;
  }
  errors.rms = std::sqrt(squares / static_cast<double>(image.pixels.size()));
  return errors;
}

ErrorMetrics compareImages(const FloatImage& image, const FloatImage& reference) {
  const ValueErrors values = compareValues(image, reference);
  ErrorMetrics metrics{.rms = values.rms, .max = values.max, .nonFinite = values.nonFinite};
  metrics.psnr =
      metrics.rms > 0.0 ? -20.0 * std::log10(metrics.rms) : std::numeric_limits<double>::infinity();
  metrics.ssim = meanStructuralSimilarity(image, reference);
  metrics.blocks = compareBlocks(image, reference);
  return metrics;
}

FloatImage differenceImage(const FloatImage& image, const FloatImage& reference, float enhancement) {
  requireSameShape(image, reference);
  FloatImage difference{image.size, image.channels, std::vector<float>(image.pixels.size())};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const bool finite = areFinite(image.pixels[i], reference.pixels[i]);
    const auto error = static_cast<float>(absoluteError(image.pixels[i], reference.pixels[i]));
    difference.pixels[i] = finite ? std::min(error * enhancement, 1.0f) : 1.0f;
  }
  return difference;
}

}  // namespace host
