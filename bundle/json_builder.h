// SPDX-License-Identifier: MIT
// JSON text -> nlohmann::json, and its destruction without allocation.
// nlohmann's destructor of a nested value moves its elements to a vector. When memory is exhausted,
// that throws inside a destructor and terminates the process. Nested values that may exist during
// an allocation failure are therefore built and dismantled here.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace lichen {

struct JsonFault {
  enum class Kind {
    syntax,
    range, ///< a number beyond the range of double
    count  ///< too many values
  };
  Kind kind = Kind::syntax;
  std::size_t byte = 0; ///< byte offset of a fault that the parser found
};

/// Parses `text` into `document` as json::parse() does: among members of the same name the last one
/// wins. Reads at most `mostValues` values, counted at all depths. Throws std::bad_alloc. After an
/// exception or a fault, `document` holds the values read so far; pass it to dismantle().
[[nodiscard]] std::optional<JsonFault> buildJson(std::span<const std::byte> text,
                                                 std::size_t mostValues, nlohmann::json& document);

/// Empties an array or object, leaves first. The recursion depth equals the nesting depth.
void dismantle(nlohmann::json& value) noexcept;

} // namespace lichen
