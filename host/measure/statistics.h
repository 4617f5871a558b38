// The figures that summarise repeated timings. Medians, not means: a run that another process disturbed is an
// outlier, not a measurement.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace host {

struct Summary {
  double median = 0.0;
  double min = 0.0;
  double max = 0.0;
  int runs = 0;
};

/// The value below which the given share of `values` lies. Throws std::invalid_argument for no values at all.
double quantile(std::vector<double> values, double share);

/// Throws std::invalid_argument for no values at all.
double median(std::vector<double> values);
Summary summarize(std::span<const double> values);

/// Throws std::invalid_argument for no values at all.
double mean(std::span<const double> values);

/// A ratio of two medians and an interval for it.
struct RatioEstimate {
  /// Of fewer pairs, not even the range covers the median with 95 %: it does with 1 - 2^(1 - pairs).
  static constexpr std::size_t kLeastPairs = 6;

  double ratio = 0.0;
  double low = 0.0;
  double high = 0.0;
  std::size_t pairs = 0;

  /// Whether the whole interval is within `fraction` of the ratio, and is one of enough pairs.
  [[nodiscard]] bool isKnownWithin(double fraction) const;
};

/// median(numerators) / median(denominators), the i-th of each taken one right after the other. The interval
/// is the 95 % percentile bootstrap over such pairs (Efron and Tibshirani, An Introduction to the Bootstrap,
/// 1993, chapter 13): pairs, since whatever slows the machine down for a while slows both of a pair. The same
/// values give the same interval. Throws std::invalid_argument if the counts differ, are zero, or a value is
/// not positive.
RatioEstimate ratioOfMedians(std::span<const double> numerators, std::span<const double> denominators);

/// The median of `values` and, likewise, the interval in which it lies. Throws for none, or one not positive.
RatioEstimate estimateMedian(std::span<const double> values);

}  // namespace host
