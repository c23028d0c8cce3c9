// SPDX-License-Identifier: MIT
// A JSON document that is being written, and its text.
// nlohmann's values are not used for that: their destructor allocates, so where memory runs out
// while a document is built, the process would end.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// A value of a document. Members keep the order in which they are set, so that the same bundle
/// gives the same bytes. Strings are UTF-8; others throw nlohmann::json::exception.
class JsonTree {
public:
  JsonTree() = default; ///< null, until it gets a member or an element
  JsonTree(std::string_view text) : kind_(Kind::scalar), text_(textOf(text)) {}
  JsonTree(const std::string& text) : JsonTree(std::string_view(text)) {}
  JsonTree(const char* text) : JsonTree(std::string_view(text)) {}
  template <std::same_as<bool> Flag> // nothing else, such as a pointer, becomes a bool
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
  /// An object where every value is an array of a string and another value, an array elsewhere.
  JsonTree(std::initializer_list<JsonTree> values);

  [[nodiscard]] static JsonTree array();
  [[nodiscard]] static JsonTree object();

  /// The member of an object, null where it was absent. The next new member ends the reference.
  JsonTree& operator[](std::string_view key);
  [[nodiscard]] bool contains(std::string_view key) const;
  void erase(std::string_view key);

  void push_back(JsonTree value);
  /// Whether an array has an element like this one.
  [[nodiscard]] bool has(const JsonTree& element) const;

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }

  /// The document on one line, or indented by two spaces a level.
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
  [[nodiscard]] std::size_t find(std::string_view key) const; ///< size() where it is absent
  void append(std::string& text, const std::string& lineEnd, std::string_view step,
              std::string_view colon) const;

  Kind kind_ = Kind::null;
  std::string text_;              ///< of a scalar, as the document has it
  std::vector<std::string> keys_; ///< of an object's values, in quotes
  std::vector<JsonTree> values_;
};

} // namespace lichen
