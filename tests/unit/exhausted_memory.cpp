// SPDX-License-Identifier: MIT
// Makes memory run out on demand; see exhausted_memory.h.
#include "exhausted_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local int untilExhausted = 0; // counts down while positive
thread_local bool exhausted = false;
thread_local int spared = 0;
thread_local std::size_t mostBytes = 0;
thread_local std::size_t leastRefused = 0;
thread_local auto failingNow = lichen::test::Failing::fromNth;

} // namespace

namespace lichen::test {

ExhaustedMemory::ExhaustedMemory(int n, std::size_t leastBytes, Failing failing) {
  untilExhausted = n;
  failingNow = failing;
  leastRefused = leastBytes;
  mostBytes = 0;
}
ExhaustedMemory::~ExhaustedMemory() {
  untilExhausted = 0;
  exhausted = false;
}
bool ExhaustedMemory::reached() { return exhausted; }
std::size_t ExhaustedMemory::largest() { return mostBytes; }
void ExhaustedMemory::spare() { ++spared; }
void ExhaustedMemory::refuse() { --spared; }

} // namespace lichen::test

void* operator new(std::size_t size) {
  mostBytes = std::max(mostBytes, size);
  if (spared == 0 && size >= leastRefused) {
    const bool isNth = untilExhausted > 0 && --untilExhausted == 0;
    exhausted = exhausted || isNth;
    if (isNth || (exhausted && failingNow == lichen::test::Failing::fromNth))
      throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
