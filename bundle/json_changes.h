// SPDX-License-Identifier: MIT
// Changes to a JSON text that leave every other byte of it as it is.
#pragma once

#include <lichen/json_tree.h>
#include <lichen/result.h>

#include <deque>
#include <map>
#include <optional>

namespace lichen {

/// What is to become of one value of a document, and of what lies in it.
class JsonChange {
public:
  /// The change to a member of an object. One that is absent is added, at the object's end.
  JsonChange& member(std::string_view key);
  /// The change to an element of an array, which must be there.
  JsonChange& element(std::size_t index) { return elements_[index]; }
  /// Takes the place of the value. Changes inside it are then not asked for.
  void set(JsonTree value) { value_ = std::move(value); }
  /// Adds an element at the end of an array, which is made where it is absent.
  void append(JsonTree value) { appended_.push_back(std::move(value)); }
  /// Leaves a member out.
  void remove() { isRemoved_ = true; }

  [[nodiscard]] bool isNone() const {
    return !value_ && !isRemoved_ && members_.empty() && elements_.empty() && appended_.empty();
  }

private:
  friend class JsonRewriter;

  struct Member;

  /// The value where there was none.
  [[nodiscard]] JsonTree made() const;

  std::optional<JsonTree> value_;
  bool isRemoved_ = false;
  std::deque<Member> members_; ///< in the order in which they were asked for; stay in their places
  std::map<std::size_t, JsonChange> elements_;
  std::vector<JsonTree> appended_;
};

struct JsonChange::Member {
  std::string key;
  JsonChange change;
};

/// `text`, which a JSON parser has accepted, with the changes. What is added stands like its
/// neighbours, on one line. Errors, badInput with a JSON pointer: a change to a value of another
/// type, to an element that is absent, or to a member that stands twice.
/// Throws std::bad_alloc. Time: linear in the text.
[[nodiscard]] Result<std::string> changedJson(std::string_view text, const JsonChange& change);

} // namespace lichen
