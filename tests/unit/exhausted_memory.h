// SPDX-License-Identifier: MIT
// Memory that runs out on demand. A program that links this has its operator new replaced.
#pragma once

namespace lichen::test {

/// While it lives, the n-th allocation of this thread (1 is the next) and all after it throw
/// std::bad_alloc.
class ExhaustedMemory {
public:
  explicit ExhaustedMemory(int n);
  ~ExhaustedMemory();
  ExhaustedMemory(const ExhaustedMemory&) = delete;
  ExhaustedMemory& operator=(const ExhaustedMemory&) = delete;

  /// Whether that allocation was asked for.
  [[nodiscard]] static bool reached();

  /// Between these, allocations are neither counted nor refused.
  static void spare();
  static void refuse();
};

} // namespace lichen::test
