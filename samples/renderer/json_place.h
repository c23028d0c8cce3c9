// SPDX-License-Identifier: MIT
// Checked access to a JSON document: every fault throws a Fault that names its JSON pointer and
// what would be accepted. Validation code only; the Fault is caught at its public boundary.
#pragma once

#include <lichen/result.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

namespace lichen::renderer {

/// More than the largest scenes in the wild have of anything. An empty object of 3 bytes takes up
/// to 2 KiB when loaded, so that a small file could otherwise fill the memory.
inline constexpr std::size_t kMaxElements = std::size_t(1) << 18;

/// A fault of the document, as one line without the file's name.
struct Fault {
  std::string message;
  ErrorKind kind = ErrorKind::badInput;
};

/// A value of the document and where it stands.
class Place {
public:
  Place(const nlohmann::json& value, std::string pointer)
      : value_(&value), pointer_(std::move(pointer)) {}

  [[nodiscard]] const nlohmann::json& json() const { return *value_; }
  [[noreturn]] void fail(const std::string& what) const;

  /// Members of an object. All of them fail unless this is an object.
  [[nodiscard]] std::optional<Place> find(const char* key) const;
  [[nodiscard]] Place member(const char* key) const; ///< fails when absent
  /// Calls `visit` for each element of the array `key`, or not at all when the member is absent.
  /// An empty array fails, as glTF's schema has it, and so does one of more than kMaxElements.
  void each(const char* key, const std::function<void(const Place&, std::size_t)>& visit) const;
  [[nodiscard]] std::size_t countOf(const char* key) const; ///< of an array; 0 when absent

  /// An integer in [0, limit): an index into an array of `limit` values.
  [[nodiscard]] std::size_t asIndex(std::size_t limit) const;
  [[nodiscard]] std::optional<std::size_t> index(const char* key, std::size_t limit) const;
  double asNumber(double low, double high) const; ///< in [low, high], that a float can hold
  /// An integer in [low, high].
  [[nodiscard]] std::uint64_t integer(const char* key, std::uint64_t low, std::uint64_t high,
                                      std::optional<std::uint64_t> absent = std::nullopt) const;
  /// One of the listed integers; nothing when absent.
  std::optional<std::uint64_t> oneOf(const char* key,
                                     std::initializer_list<std::uint64_t> accepted) const;
  /// A number in [low, high] that a float can hold; `absent` when the member is absent.
  double number(const char* key, double low, double high, double absent) const;
  /// An array of exactly `count` numbers in [low, high]; nothing to say when absent.
  void numbers(const char* key, std::size_t count, double low, double high) const;
  [[nodiscard]] std::optional<std::string> string(const char* key) const;
  void boolean(const char* key) const;
  [[nodiscard]] Place extension(const char* name) const; ///< an empty object when absent

private:
  const nlohmann::json* value_;
  std::string pointer_;
};

} // namespace lichen::renderer
