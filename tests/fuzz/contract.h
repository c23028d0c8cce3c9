// SPDX-License-Identifier: MIT
// What the fuzzers' entry points require of a reader.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace lichen::fuzz {

/// Ends the program, so that a fuzzer keeps the input.
inline void require(bool condition, const char* what) {
  if (condition)
    return;
  std::fprintf(stderr, "broken contract: %s\n", what);
  std::abort();
}

/// Printable ASCII.
inline bool isOneLine(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

} // namespace lichen::fuzz
