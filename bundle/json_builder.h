// SPDX-License-Identifier: MIT
// JSON text -> nlohmann::json, and its end, without an allocation where none may fail.
// nlohmann's destructor of a nested value moves its elements to a vector: where memory is exhausted
// that throws inside a destructor, and the process ends. Nested values that an allocation failure
// can meet are therefore built and taken apart here.
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
  std::size_t byte = 0; ///< of a fault that the parser found
};

/// Parses `text` into `document`, as json::parse() does: of members of one name the last counts.
/// Reads up to `mostValues` of any kind, however deep they lie. Throws std::bad_alloc. Then, and
/// after a fault, `document` holds what was read, for dismantle().
[[nodiscard]] std::optional<JsonFault> buildJson(std::span<const std::byte> text,
                                                 std::size_t mostValues, nlohmann::json& document);

/// Empties an array or object from its leaves on. Recursion goes as deep as it is nested.
void dismantle(nlohmann::json& value) noexcept;

} // namespace lichen
