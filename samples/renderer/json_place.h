// SPDX-License-Identifier: MIT
// Checked access to a JSON document. Every fault throws a Fault whose message has the JSON pointer
// and what was expected. Only scene loading uses this; its public functions catch the Fault.
#pragma once

#include <lichen/result.h>

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

namespace lichen::renderer {

/// Larger than any array of known scenes. An empty JSON object takes 3 bytes in the file and up to
/// 2 KiB when loaded, so without a bound a small file could exhaust memory.
inline constexpr std::size_t kMaxElements = std::size_t(1) << 18;

inline constexpr double kLargest = std::numeric_limits<float>::max();

/// A fault in the document: one line without the file name.
struct Fault {
  std::string message;
  ErrorKind kind = ErrorKind::badInput;
};

/// A JSON value and its JSON pointer.
class Place {
public:
  Place(const nlohmann::json& value, std::string pointer)
      : value_(&value), pointer_(std::move(pointer)) {}

  [[nodiscard]] const nlohmann::json& json() const { return *value_; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[noreturn]] void fail(const std::string& what) const;

  /// Members of an object. All of them fail if this value is not an object.
  [[nodiscard]] std::optional<Place> find(const char* key) const;
  [[nodiscard]] Place member(const char* key) const; ///< fails when absent
  /// Calls `visit` for each element of the array `key`; does nothing if the member is absent. Fails
  /// for an empty array, as glTF's schema requires, and for more than kMaxElements.
  void each(const char* key, const std::function<void(const Place&, std::size_t)>& visit) const;
  [[nodiscard]] std::size_t countOf(const char* key) const; ///< elements of an array; 0 when absent
  [[nodiscard]] Place at(std::size_t index) const;          ///< an existing element of an array

  /// An integer in [0, limit): an index into an array of `limit` elements.
  [[nodiscard]] std::size_t asIndex(std::size_t limit) const;
  [[nodiscard]] std::optional<std::size_t> index(const char* key, std::size_t limit) const;
  /// In [low, high], within the range of a float.
  [[nodiscard]] double asNumber(double low = -kLargest, double high = kLargest) const;
  /// An integer in [low, high].
  [[nodiscard]] std::uint64_t integer(const char* key, std::uint64_t low, std::uint64_t high,
                                      std::optional<std::uint64_t> absent = std::nullopt) const;
  /// One of the accepted integers; nullopt when absent.
  std::optional<std::uint64_t> oneOf(const char* key,
                                     std::initializer_list<std::uint64_t> accepted) const;
  /// A number in [low, high] within the range of a float; `absent` when the member is absent.
  [[nodiscard]] double number(const char* key, double absent, double low = -kLargest,
                              double high = kLargest) const;
  /// A vector or matrix of glm, from an array of exactly as many numbers in [low, high].
  template <class Vector>
  [[nodiscard]] Vector vector(const char* key, Vector absent, double low = -kLargest,
                              double high = kLargest) const {
    constexpr std::size_t kCount = sizeof(Vector) / sizeof(*glm::value_ptr(absent));
    const std::optional<Place> found = find(key);
    if (!found)
      return absent;
    if (!found->json().is_array() || found->json().size() != kCount)
      found->fail("expected an array of " + std::to_string(kCount) + " numbers");
    for (std::size_t i = 0; i < kCount; ++i)
      glm::value_ptr(absent)[i] =
          std::decay_t<decltype(*glm::value_ptr(absent))>(found->at(i).asNumber(low, high));
    return absent;
  }
  [[nodiscard]] std::optional<std::string> string(const char* key) const;
  /// One of the accepted strings; the first when absent.
  [[nodiscard]] std::string oneOf(const char* key,
                                  std::initializer_list<const char*> accepted) const;
  [[nodiscard]] bool boolean(const char* key) const; ///< false when absent
  [[nodiscard]] std::optional<Place> findExtension(const char* name) const;
  [[nodiscard]] Place extension(const char* name) const; ///< an empty object when absent

private:
  const nlohmann::json* value_;
  std::string pointer_;
};

} // namespace lichen::renderer
