// The five local moments (the means of a, b, a*a, b*b and a*b) are filtered separably: along each row into a
// ring of as many filtered rows as the window is high, then across the rows of that ring. At 3840x2160 this
// is 110 instead of 605 multiplications a pixel, and the working set stays in the cache.
#include "host/measure/structural_similarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace host {
namespace {

constexpr int kRadius = 5;
constexpr int kWidth = 2 * kRadius + 1;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 0.01;  // (K1 L)^2 with L = 1, the range of the values
constexpr double kC2 = 0.03 * 0.03;  // (K2 L)^2

std::array<double, kWidth> gaussianWeights() {
  std::array<double, kWidth> weights{};
  double sum = 0.0;
  for (int i = 0; i < kWidth; ++i) {
    const double distance = i - kRadius;
    weights[i] = std::exp(-distance * distance / (2.0 * kSigma * kSigma));
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Where windows are centred along one axis, and the share of a window's weight that is inside of the image.
struct Axis {
  Axis(int pixels, const std::array<double, kWidth>& weights)
      : length(pixels),
        begin(pixels >= kWidth ? kRadius : 0),
        end(pixels >= kWidth ? pixels - kRadius : pixels),
        weightInside(pixels, 0.0) {
    for (int center = begin; center < end; ++center)
      for (int position = first(center); position <= last(center); ++position)
        weightInside[center] += weights[position - center + kRadius];
  }
  [[nodiscard]] static int first(int center) { return std::max(center - kRadius, 0); }
  [[nodiscard]] int last(int center) const { return std::min(center + kRadius, length - 1); }

  int length;
  int begin;
  int end;
  std::vector<double> weightInside;
};

using Row = std::vector<double>;
enum Moment : std::size_t { kA, kB, kAA, kBB, kAB, kMoments };
using Moments = std::array<Row, kMoments>;

class MomentFilter {
 public:
  explicit MomentFilter(const ChannelPair& pair)
      : pair_(pair),
        weights_(gaussianWeights()),
        columns_(pair.size.x, weights_),
        rows_(pair.size.y, weights_),
        products_(emptyMoments()),
        window_(emptyMoments()) {
    ring_.fill(emptyMoments());
  }

  double meanSimilarity() {
    double sum = 0.0;
    int nextRow = 0;
    for (int y = rows_.begin; y < rows_.end; ++y) {
      while (nextRow <= rows_.last(y)) filterRow(nextRow++);
      filterAcrossRows(y);
      sum += similarityOfRow(y);
    }
    const double windows = static_cast<double>(columns_.end - columns_.begin) * (rows_.end - rows_.begin);
    return sum / windows;
  }

 private:
  [[nodiscard]] Moments emptyMoments() const {
    Moments moments;
    moments.fill(Row(pair_.size.x, 0.0));
    return moments;
  }

  /// sum[x] += weight * values[x + offset] for each x in begin..end-1 for which that exists.
  void addScaled(Row& sum, const Row& values, int offset, double weight) const {
    const int begin = std::max(columns_.begin, -offset);
    const int end = std::min(columns_.end, columns_.length - offset);
    const double* source = values.data() + offset;
    for (int x = begin; x < end; ++x) sum[x] += weight * source[x];
  }

  void multiplyRow(int y) {
    const float* a = pair_.a.data() + static_cast<std::size_t>(y) * pair_.size.x;
    const float* b = pair_.b.data() + static_cast<std::size_t>(y) * pair_.size.x;
    for (int x = 0; x < pair_.size.x; ++x) {
      products_[kA][x] = a[x];
      products_[kB][x] = b[x];
      products_[kAA][x] = products_[kA][x] * products_[kA][x];
      products_[kBB][x] = products_[kB][x] * products_[kB][x];
      products_[kAB][x] = products_[kA][x] * products_[kB][x];
    }
  }

  void filterRow(int y) {
    multiplyRow(y);
    Moments& filtered = ring_[y % kWidth];
    for (std::size_t moment = 0; moment < kMoments; ++moment) {
      std::ranges::fill(filtered[moment], 0.0);
      for (int tap = -kRadius; tap <= kRadius; ++tap)
        addScaled(filtered[moment], products_[moment], tap, weights_[tap + kRadius]);
    }
  }

  void filterAcrossRows(int y) {
    for (std::size_t moment = 0; moment < kMoments; ++moment) {
      std::ranges::fill(window_[moment], 0.0);
      for (int row = Axis::first(y); row <= rows_.last(y); ++row)
        addScaled(window_[moment], ring_[row % kWidth][moment], 0, weights_[row - y + kRadius]);
    }
  }

  [[nodiscard]] double similarityOfRow(int y) const {
    double sum = 0.0;
    for (int x = columns_.begin; x < columns_.end; ++x) {
      const double scale = 1.0 / (columns_.weightInside[x] * rows_.weightInside[y]);
      const double meanA = window_[kA][x] * scale;
      const double meanB = window_[kB][x] * scale;
      const double varianceSum = (window_[kAA][x] + window_[kBB][x]) * scale - meanA * meanA - meanB * meanB;
      const double covariance = window_[kAB][x] * scale - meanA * meanB;
      sum += (2.0 * meanA * meanB + kC1) * (2.0 * covariance + kC2) /
             ((meanA * meanA + meanB * meanB + kC1) * (varianceSum + kC2));
    }
    return sum;
  }

  const ChannelPair& pair_;
  std::array<double, kWidth> weights_;
  Axis columns_;
  Axis rows_;
  Moments products_;                  // of the row being filtered
  std::array<Moments, kWidth> ring_;  // rows filtered along x
  Moments window_;                    // filtered along both
};

}  // namespace

ChannelPair channelPair(const FloatImage& image, const FloatImage& reference, int channel) {
  const std::size_t count = static_cast<std::size_t>(image.size.x) * image.size.y;
  ChannelPair pair{image.size, std::vector<float>(count), std::vector<float>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const float a = image.pixels[i * image.channels + channel];
    const float b = reference.pixels[i * image.channels + channel];
    const bool finite = std::isfinite(a) && std::isfinite(b);
    pair.a[i] = finite ? a : 1.0f;
    pair.b[i] = finite ? b : 0.0f;
  }
  return pair;
}

double structuralSimilarity(const ChannelPair& pair) {
  return MomentFilter(pair).meanSimilarity();
}

}  // namespace host
