// SPDX-License-Identifier: MIT
// JSON values -> text; see json_tree.h. nlohmann writes the numbers and strings.
#include <lichen/json_tree.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>

namespace lichen {

JsonTree::JsonTree(std::initializer_list<JsonTree> values) : kind_(Kind::array) {
  if (!std::all_of(values.begin(), values.end(), [](const JsonTree& v) { return v.isMember(); })) {
    values_ = values;
    return;
  }
  kind_ = Kind::object;
  for (const JsonTree& member : values) {
    keys_.push_back(member.values_[0].text_);
    values_.push_back(member.values_[1]);
  }
}

JsonTree JsonTree::array() {
  JsonTree tree;
  tree.kind_ = Kind::array;
  return tree;
}

JsonTree JsonTree::object() {
  JsonTree tree;
  tree.kind_ = Kind::object;
  return tree;
}

bool JsonTree::isMember() const {
  return kind_ == Kind::array && values_.size() == 2 && values_[0].text_.starts_with('"');
}

std::size_t JsonTree::find(std::string_view key) const {
  return std::size_t(std::find(keys_.begin(), keys_.end(), textOf(key)) - keys_.begin());
}

JsonTree& JsonTree::operator[](std::string_view key) {
  assert(kind_ == Kind::null || kind_ == Kind::object);
  kind_ = Kind::object;
  const std::size_t place = find(key);
  if (place == keys_.size()) {
    values_.emplace_back();
    keys_.push_back(textOf(key));
  }
  return values_[place];
}

bool JsonTree::contains(std::string_view key) const { return find(key) < keys_.size(); }

void JsonTree::erase(std::string_view key) {
  const std::size_t place = find(key);
  if (place == keys_.size())
    return;
  keys_.erase(keys_.begin() + std::ptrdiff_t(place));
  values_.erase(values_.begin() + std::ptrdiff_t(place));
}

void JsonTree::push_back(JsonTree value) {
  assert(kind_ == Kind::null || kind_ == Kind::array);
  kind_ = Kind::array;
  values_.push_back(std::move(value));
}

bool JsonTree::has(const JsonTree& element) const {
  return std::find(values_.begin(), values_.end(), element) != values_.end();
}

std::string JsonTree::textOf(std::string_view text) { return nlohmann::json(text).dump(); }
std::string JsonTree::textOf(double value) { return nlohmann::json(value).dump(); }
std::string JsonTree::textOf(std::int64_t value) { return std::to_string(value); }
std::string JsonTree::textOf(std::uint64_t value) { return std::to_string(value); }

/// Appends the text of a value. `lineEnd` precedes and follows the values of an array or object,
/// `step` indents each of them, and `colon` follows keys.
void JsonTree::append(std::string& text, const std::string& lineEnd, std::string_view step,
                      std::string_view colon) const {
  if (kind_ == Kind::null || kind_ == Kind::scalar) {
    text += kind_ == Kind::null ? "null" : text_;
    return;
  }
  const bool isObject = kind_ == Kind::object;
  text += isObject ? '{' : '[';
  const std::string inside = lineEnd + std::string(step);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    text += i == 0 ? "" : ",";
    text += inside;
    if (isObject) {
      text += keys_[i];
      text += colon;
    }
    values_[i].append(text, inside, step, colon);
  }
  text += values_.empty() ? "" : lineEnd;
  text += isObject ? '}' : ']';
}

std::string JsonTree::compact() const {
  std::string text;
  append(text, "", "", ":");
  return text;
}

std::string JsonTree::indented() const {
  std::string text;
  append(text, "\n", "  ", ": ");
  return text;
}

} // namespace lichen
