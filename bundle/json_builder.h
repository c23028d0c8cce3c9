// SPDX-License-Identifier: MIT
// JSON text -> nlohmann::json, and its destruction without allocation; JSON text ->
// ordered_json. nlohmann's destructor of a nested value moves its elements to a vector. When memory
// is exhausted, that throws inside a destructor and terminates the process. The engine plugin must
// survive that, so documents that are read are built and dismantled here. Documents that are
// written are plain values of nlohmann: writers report only that memory does not suffice for a
// large allocation.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace lichen {

struct JsonFault {
  enum class Kind {
    syntax,
    range, ///< a number beyond the range of double
    count, ///< too many values
    depth, ///< nested too deep
    name   ///< two members of an object have the same name
  };
  Kind kind = Kind::syntax;
  std::size_t byte = 0; ///< byte offset of a fault that the parser found
  std::string name;     ///< of a fault of kind `name`
};

/// Parses `text` into `document` as json::parse() does: among members of the same name the last
/// one wins. Reads at most `mostValues` values, counted at all depths, and `mostDepth` levels of
/// arrays and objects. Throws std::bad_alloc. After an exception or a fault, `document` holds the
/// values read so far; pass it to dismantle().
[[nodiscard]] std::optional<JsonFault> buildJson(std::span<const std::byte> text,
                                                 std::size_t mostValues, std::size_t mostDepth,
                                                 nlohmann::json& document);

/// As buildJson(), into a document that keeps the order of members, without limits. Two members of
/// the same name are a fault. Time: n log n in the members of an object.
[[nodiscard]] std::optional<JsonFault> buildOrderedJson(std::span<const std::byte> text,
                                                        nlohmann::ordered_json& document);

/// Empties an array or object, leaves first. The recursion depth equals the nesting depth.
void dismantle(nlohmann::json& value) noexcept;

} // namespace lichen
