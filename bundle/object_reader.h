// SPDX-License-Identifier: MIT
// Typed access to one JSON object. Each fault is recorded with its JSON pointer, and the reader
// returns a usable fallback, so that reading continues to the next fault.
#pragma once

#include "findings.h"

#include <nlohmann/json.hpp>

namespace lichen {

/// A member of a value that may be null or no object; null if absent.
[[nodiscard]] const nlohmann::json* memberOf(const nlohmann::json* value, std::string_view key);
/// A member that is a string; null if it is not, and as memberOf().
[[nodiscard]] const std::string* stringMember(const nlohmann::json& value, std::string_view key);

class ObjectReader {
public:
  /// Borrows all three. Records a value that is not an object; its members then count as absent,
  /// without further faults.
  ObjectReader(const nlohmann::json& value, std::string pointer, FindingList& findings);

  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[nodiscard]] std::string pointerTo(const char* key) const { return pointer_ + "/" + key; }

  /// A mandatory member. If absent, records "required" and returns null.
  [[nodiscard]] const nlohmann::json* required(const char* key);
  /// An optional member. If absent, returns null without a fault.
  [[nodiscard]] const nlohmann::json* optional(const char* key);

  /// Records a fault of a member.
  void error(const char* code, const char* key, std::string message);

  /// Mandatory numbers (numberOr: optional). Records "type" for another type and "range" for a
  /// value outside `range`.
  [[nodiscard]] std::optional<double> number(const char* key, NumberRange range);
  [[nodiscard]] double numberOr(const char* key, NumberRange range, double fallback);
  [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key, NumberRange range);
  /// Two numbers. Records "count" for another size.
  [[nodiscard]] std::optional<std::array<double, 2>> pair(const char* key, NumberRange range);
  [[nodiscard]] std::array<double, 2> pairOr(const char* key, NumberRange range,
                                             const std::array<double, 2>& fallback);
  /// An integer in [least, most] (integerOr: optional). Records `rangeCode` for one outside.
  [[nodiscard]] std::optional<std::uint64_t> integer(const char* key, std::uint64_t most,
                                                     const char* rangeCode = "range",
                                                     std::uint64_t least = 0);
  template <class Integer>
  [[nodiscard]] Integer integerOr(const char* key, std::uint64_t most, Integer fallback,
                                  std::uint64_t least = 0) {
    const auto value = has(key) ? integer(key, most, "range", least) : std::nullopt;
    return value ? Integer(*value) : fallback;
  }
  [[nodiscard]] std::optional<std::string> text(const char* key);
  /// An array of 1 to `most` elements. Otherwise records a fault ("count" for another size) and
  /// returns null.
  [[nodiscard]] const nlohmann::json* array(const char* key, std::size_t most);
  /// Whether the member exists. Does not count as reading it.
  [[nodiscard]] bool has(const char* key) const;

  /// Records a warning for each member that no call above has read, except "extensions" and
  /// "extras", which every object may have.
  void warnOfUnknown();

private:
  [[nodiscard]] std::optional<double> checkedNumber(const nlohmann::json& value,
                                                    const std::string& pointer, NumberRange range);

  const nlohmann::json& value_;
  std::string pointer_;
  FindingList& findings_;
  std::vector<std::string> asked_{"extensions", "extras"};
};

} // namespace lichen
