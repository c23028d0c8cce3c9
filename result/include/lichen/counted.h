// SPDX-License-Identifier: MIT
// A number with its noun, for messages.
#pragma once

#include <cstdint>
#include <string>

namespace lichen {

/// "1 level", "2 levels".
[[nodiscard]] inline std::string counted(std::uint64_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace lichen
