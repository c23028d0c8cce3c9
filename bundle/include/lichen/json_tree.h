// SPDX-License-Identifier: MIT
// A JSON document under construction, and its text. nlohmann's values are unsuitable: their
// destructor allocates, so running out of memory while building a document would terminate the
// process.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// A value of a document. Members keep their insertion order, so the same bundle always gives the
/// same bytes. Strings must be UTF-8; others throw nlohmann::json::exception.
class JsonTree {
public:
  JsonTree() = default; ///< null, until it gets a member or an element
  JsonTree(std::string_view text) : kind_(Kind::scalar), text_(textOf(text)) {}
  JsonTree(const std::string& text) : JsonTree(std::string_view(text)) {}
  JsonTree(const char* text) : JsonTree(std::string_view(text)) {}
  template <std::same_as<bool> Flag> // prevents conversion from pointers
  JsonTree(Flag value) : kind_(Kind::scalar), text_(value ? "true" : "false") {}
  template <std::floating_point Number>
  JsonTree(Number value) : kind_(Kind::scalar), text_(textOf(double(value))) {}
  template <std::unsigned_integral Number>
  requires(!std::same_as<Number, bool>) JsonTree(Number value)
      : kind_(Kind::scalar), text_(textOf(std::uint64_t(value))) {}
  template <std::signed_integral Number>
  JsonTree(Number value) : kind_(Kind::scalar), text_(textOf(std::int64_t(value))) {}
  template <class Value>
  JsonTree(const std::vector<Value>& values)
      : kind_(Kind::array), values_(values.begin(), values.end()) {}
  template <class Value, std::size_t kSize>
  JsonTree(const std::array<Value, kSize>& values)
      : kind_(Kind::array), values_(values.begin(), values.end()) {}
  /// An object if every value is an array of a string and another value; otherwise an array.
  JsonTree(std::initializer_list<JsonTree> values);

  [[nodiscard]] static JsonTree array();
  [[nodiscard]] static JsonTree object();

  /// The member of an object; adds a null member if absent. Adding another member invalidates the
  /// reference.
  JsonTree& operator[](std::string_view key);
  [[nodiscard]] bool contains(std::string_view key) const;
  void erase(std::string_view key);

  void push_back(JsonTree value);
  /// Whether an array contains an equal element.
  [[nodiscard]] bool has(const JsonTree& element) const;

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }

  /// The document on one line, or indented by two spaces per level.
  [[nodiscard]] std::string compact() const;
  [[nodiscard]] std::string indented() const;

  bool operator==(const JsonTree&) const = default;

private:
  enum class Kind { null, scalar, array, object };

  [[nodiscard]] static std::string textOf(std::string_view text);
  [[nodiscard]] static std::string textOf(double value);
  [[nodiscard]] static std::string textOf(std::int64_t value);
  [[nodiscard]] static std::string textOf(std::uint64_t value);

  [[nodiscard]] bool isMember() const;
  [[nodiscard]] std::size_t find(std::string_view key) const; ///< size() if absent
  void append(std::string& text, const std::string& lineEnd, std::string_view step,
              std::string_view colon) const;

  Kind kind_ = Kind::null;
  std::string text_;              ///< JSON text of a scalar
  std::vector<std::string> keys_; ///< keys of an object's values, in quotes
  std::vector<JsonTree> values_;
};

} // namespace lichen
