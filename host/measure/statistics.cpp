#include "host/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <stdexcept>

namespace host {
namespace {

constexpr int kResamples = 1000;  // enough for the 2.5 % quantiles, below a millisecond for 31 pairs
constexpr double kTailProbability = 0.025;  // 95 % two-sided

void requirePositive(std::span<const double> values) {
  if (!std::ranges::all_of(values, [](double value) { return value > 0.0 && std::isfinite(value); }))
    throw std::invalid_argument("a ratio of medians needs positive, finite times");
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  if (values.empty()) throw std::invalid_argument("a quantile of no values is undefined");
  const auto index = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  const auto position = values.begin() + index;
  std::nth_element(values.begin(), position, values.end());
  return *position;
}

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("the median of no values is undefined");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2.0;
}

double mean(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("the mean of no values is undefined");
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Summary summarize(std::span<const double> values) {
  Summary summary;
  summary.median = median({values.begin(), values.end()});
  const auto [min, max] = std::ranges::minmax(values);
  summary.min = min;
  summary.max = max;
  summary.runs = static_cast<int>(values.size());
  return summary;
}

bool RatioEstimate::isKnownWithin(double fraction) const {
  return pairs >= kLeastPairs && high - ratio <= fraction * ratio && ratio - low <= fraction * ratio;
}

RatioEstimate ratioOfMedians(std::span<const double> numerators, std::span<const double> denominators) {
  if (numerators.size() != denominators.size() || numerators.empty())
    throw std::invalid_argument(
        "a ratio of medians needs as many numerators as denominators, and at least one");
  requirePositive(numerators);
  requirePositive(denominators);

  const std::size_t count = numerators.size();
  std::mt19937 random(
      1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): a report must be reproducible from its times
  std::uniform_int_distribution<std::size_t> pick(0, count - 1);
  std::vector<double> ratios;
  ratios.reserve(kResamples);
  std::vector<double> top(count);
  std::vector<double> bottom(count);
  for (int resample = 0; resample < kResamples; ++resample) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t pair = pick(random);
      top[i] = numerators[pair];
      bottom[i] = denominators[pair];
    }
    ratios.push_back(median(top) / median(bottom));
  }

  RatioEstimate estimate;
  estimate.pairs = count;
  estimate.ratio =
      median({numerators.begin(), numerators.end()}) / median({denominators.begin(), denominators.end()});
  estimate.low = std::min(quantile(ratios, kTailProbability), estimate.ratio);
  estimate.high = std::max(quantile(ratios, 1.0 - kTailProbability), estimate.ratio);
  return estimate;
}

RatioEstimate estimateMedian(std::span<const double> values) {
  return ratioOfMedians(values, std::vector<double>(values.size(), 1.0));
}

}  // namespace host
