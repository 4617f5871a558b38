#pragma once

#include <cmath>

namespace host {

inline bool areFinite(float a, float b) {
  return std::isfinite(a) && std::isfinite(b);
}

/// |value - expected|; 1 where either isn't finite.
inline double absoluteError(float value, float expected) {
  return areFinite(value, expected) ? std::abs(static_cast<double>(value) - static_cast<double>(expected))
                                    : 1.0;
}

}  // namespace host
