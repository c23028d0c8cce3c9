// SPDX-License-Identifier: MIT
// Typed access to one JSON object. Every fault is recorded with its JSON pointer, and a usable
// fallback is returned so that reading goes on to find the next one.
#pragma once

#include "findings.h"

#include <nlohmann/json.hpp>

namespace lichen {

class ObjectReader {
public:
  /// Borrows all three. A value that is not an object is recorded; its members then are absent, but
  /// no further fault is recorded for that.
  ObjectReader(const nlohmann::json& value, std::string pointer, FindingList& findings);

  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[nodiscard]] std::string pointerTo(const char* key) const { return pointer_ + "/" + key; }

  /// A member that must be there; null, recorded as "required", when it is not.
  [[nodiscard]] const nlohmann::json* required(const char* key);
  /// A member that may be absent: null without a record.
  [[nodiscard]] const nlohmann::json* optional(const char* key);

  /// Records a fault of a member.
  void error(const char* code, const char* key, std::string message);

  /// Numbers: "type" when it is none, "range" when outside `range`.
  [[nodiscard]] std::optional<double> number(const char* key, NumberRange range);
  [[nodiscard]] double numberOr(const char* key, NumberRange range, double fallback);
  [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key, NumberRange range);
  /// Integers in [least, most]; `rangeCode` is the code of one outside.
  [[nodiscard]] std::optional<std::uint64_t> integer(const char* key, std::uint64_t most,
                                                     const char* rangeCode = "range",
                                                     std::uint64_t least = 0);
  [[nodiscard]] std::optional<std::string> text(const char* key);
  /// A member that is an array of 1 to `most` elements; null otherwise ("count").
  [[nodiscard]] const nlohmann::json* array(const char* key, std::size_t most);
  /// Whether the member is there; does not count as having read it.
  [[nodiscard]] bool has(const char* key) const;

  /// Records a warning for each member that none of the calls above has asked for. Every object may
  /// have "extensions" and "extras".
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
