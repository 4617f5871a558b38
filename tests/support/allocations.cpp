#include "tests/support/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t allocationsOfThisThread = 0;

}  // namespace

// The array forms call these. All that the deletes below may be given must come from malloc(), or the address
// sanitizer takes them for mismatched.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocationsOfThisThread;
  return std::malloc(size == 0 ? 1 : size);
}

void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace mres::test {

AllocationCounter::AllocationCounter() : before_(allocationsOfThisThread) {}

std::size_t AllocationCounter::count() const {
  return allocationsOfThisThread - before_;
}

}  // namespace mres::test
