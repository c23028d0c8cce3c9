// SPDX-License-Identifier: MIT
// Makes memory run out on demand. A program that links this has its operator new replaced.
#pragma once

#include <cstddef>

namespace lichen::test {

/// Which allocations fail: all from the n-th on, or the n-th alone.
enum class Failing { fromNth, nth };

/// During its lifetime, this thread's n-th allocation (1 is the next) throws std::bad_alloc. Only
/// allocations of at least `leastBytes` count and fail.
class ExhaustedMemory {
public:
  /// n 0: no allocation fails
  explicit ExhaustedMemory(int n = 0, std::size_t leastBytes = 0,
                           Failing failing = Failing::fromNth);
  ~ExhaustedMemory();
  ExhaustedMemory(const ExhaustedMemory&) = delete;
  ExhaustedMemory& operator=(const ExhaustedMemory&) = delete;

  /// Whether the n-th allocation was requested.
  [[nodiscard]] static bool reached();

  /// Size in bytes of the largest allocation that this thread requested during an object's
  /// lifetime.
  [[nodiscard]] static std::size_t largest();

  /// Between spare() and refuse(), allocations neither count nor fail.
  static void spare();
  static void refuse();
};

} // namespace lichen::test
