#include "tests/support/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::size_t allocationsOfThisThread = 0;

}  // namespace

// The other forms of operator new call this one, those of operator delete the one below.
void* operator new(std::size_t size) {
  ++allocationsOfThisThread;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
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
