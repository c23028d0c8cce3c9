// SPDX-License-Identifier: MIT
// Numbers with their nouns, and lists, for messages.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace lichen {

/// "1 level", "2 levels".
[[nodiscard]] inline std::string counted(std::uint64_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "a, b, c, d and 23 others": the first four items, to keep a message short.
[[nodiscard]] inline std::string shortList(const std::vector<std::string>& items) {
  constexpr std::size_t kMostNamed = 4;
  const std::size_t named = std::min(items.size(), kMostNamed);
  std::string list;
  for (std::size_t i = 0; i < named; ++i)
    list += (i == 0 ? "" : ", ") + items[i];
  return named == items.size() ? list : list + " and " + counted(items.size() - named, "other");
}

} // namespace lichen
