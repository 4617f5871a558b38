#include "host/measure/temporal_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "host/measure/block_errors.h"
#include "host/measure/error_metrics.h"
#include "host/measure/statistics.h"

namespace host {
namespace {

double meanSquare(const FloatImage& image, const FloatImage& reference) {
  return std::pow(compareValues(image, reference).rms, 2.0);
}

/// What has to be added to the picture `before` to have `after`, in its place. Not finite where either isn't.
void makeChange(FloatImage& before, const FloatImage& after) {
  for (std::size_t i = 0; i < before.pixels.size(); ++i)
    before.pixels[i] = after.pixels[i] - before.pixels[i];
}

}  // namespace

void TemporalErrorSum::add(FloatImage technique, FloatImage reference) {
  if (sums_.frames > 0) addChanges(technique, reference);
  ++sums_.frames;
  technique_ = std::move(technique);
  reference_ = std::move(reference);
}

void TemporalErrorSum::addChanges(const FloatImage& technique, const FloatImage& reference) {
  sums_.techniqueChange += meanSquare(technique, technique_);
  sums_.referenceChange += meanSquare(reference, reference_);
  makeChange(technique_, technique);
  makeChange(reference_, reference);
  const ValueErrors errors = compareValues(technique_, reference_);
  sums_.rms += errors.rms * errors.rms;
  sums_.max = std::max(sums_.max, errors.max);
  sums_.nonFinite += errors.nonFinite;
  const std::vector<double> blocks = blockErrors(technique_, reference_);
  blocks_.insert(blocks_.end(), blocks.begin(), blocks.end());
}

TemporalErrors TemporalErrorSum::result() const {
  if (sums_.frames < 2) throw std::invalid_argument("a change needs two frames");
  TemporalErrors errors = sums_;
  for (double* figure : {&errors.rms, &errors.techniqueChange, &errors.referenceChange})
    *figure = std::sqrt(*figure / (errors.frames - 1));
  errors.blockMax = std::ranges::max(blocks_);
  errors.blockPercentile99 = quantile(blocks_, 0.99);
  return errors;
}

}  // namespace host
