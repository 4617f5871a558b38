#pragma once

#include <cstddef>

namespace mres::test {

/// Counts the calls of operator new in this thread while it lives.
class AllocationCounter {
 public:
  AllocationCounter();
  [[nodiscard]] std::size_t count() const;

 private:
  std::size_t before_;
};

}  // namespace mres::test
