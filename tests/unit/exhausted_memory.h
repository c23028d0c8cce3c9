// SPDX-License-Identifier: MIT
// Memory that runs out on demand. A program that links this has its operator new replaced.
#pragma once

#include <cstddef>

namespace lichen::test {

/// While it lives, the n-th allocation of this thread (1 is the next) and all after it throw
/// std::bad_alloc; of those of at least `leastBytes`, where smaller ones still find room.
class ExhaustedMemory {
public:
  explicit ExhaustedMemory(int n = 0, std::size_t leastBytes = 0); ///< n 0: none is refused
  ~ExhaustedMemory();
  ExhaustedMemory(const ExhaustedMemory&) = delete;
  ExhaustedMemory& operator=(const ExhaustedMemory&) = delete;

  /// Whether that allocation was asked for.
  [[nodiscard]] static bool reached();

  /// Bytes of the largest allocation that this thread has asked for while one lives.
  [[nodiscard]] static std::size_t largest();

  /// Between these, allocations are neither counted nor refused.
  static void spare();
  static void refuse();
};

} // namespace lichen::test
