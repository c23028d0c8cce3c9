// SPDX-License-Identifier: MIT
// Apart from the tests: inlined there, they look mismatched to GCC's -Wmismatched-new-delete.
#include "failing_allocations.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace lichen::test {

thread_local int allocationsUntilFailure = 0;

} // namespace lichen::test

void* operator new(std::size_t size) {
  constexpr std::size_t kCountedBytes = 1024;
  int& left = lichen::test::allocationsUntilFailure;
  if (size >= kCountedBytes && left > 0 && --left == 0)
    throw std::bad_alloc();
  if (void* memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
