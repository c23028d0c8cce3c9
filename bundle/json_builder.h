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
  std::size_t byte = 0;
  bool isRange = false; ///< a number beyond the range of double; otherwise the syntax
};

/// Parses `text` into `document`, as json::parse() does: of members of one name the last counts.
/// Throws std::bad_alloc; `document` then holds what was read, for dismantle().
[[nodiscard]] std::optional<JsonFault> buildJson(std::span<const std::byte> text,
                                                 nlohmann::json& document);

/// Empties an array or object from its leaves on. Recursion goes as deep as it is nested.
void dismantle(nlohmann::json& value) noexcept;

} // namespace lichen
