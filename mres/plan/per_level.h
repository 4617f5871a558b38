#pragma once

#include <array>
#include <cstddef>

#include "mres/effect.h"

namespace mres {

/// At most one value for each level, held in place: a plan is made every frame and must not allocate.
template <class Value>
class PerLevel {
 public:
  using value_type = Value;
  using const_iterator = const Value*;

  // NOLINTNEXTLINE(readability-identifier-naming): as the standard containers have it
  void push_back(const Value& value) { values_.at(size_++) = value; }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Value& operator[](std::size_t index) const { return values_.at(index); }
  [[nodiscard]] const Value& front() const { return values_.front(); }
  [[nodiscard]] const Value& back() const { return values_.at(size_ - 1); }
  [[nodiscard]] const_iterator begin() const { return values_.data(); }
  [[nodiscard]] const_iterator end() const { return values_.data() + size_; }

 private:
  std::array<Value, kMaxLevels> values_{};
  std::size_t size_ = 0;
};

}  // namespace mres
