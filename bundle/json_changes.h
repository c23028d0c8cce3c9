// SPDX-License-Identifier: MIT
// Edits a JSON text and preserves every other byte of it.
#pragma once

#include <lichen/json_tree.h>
#include <lichen/result.h>

#include <deque>
#include <map>
#include <optional>

namespace lichen {

/// The pending change to one value of a document and to the values inside it.
class JsonChange {
public:
  /// The change to a member of an object. An absent member is added at the object's end.
  JsonChange& member(std::string_view key);
  /// The change to an array element, which must exist.
  JsonChange& element(std::size_t index) { return elements_[index]; }
  /// Replaces the value. Changes inside the old value are then ignored.
  void set(JsonTree value) { value_ = std::move(value); }
  /// Appends an element to an array. An absent array is created.
  void append(JsonTree value) { appended_.push_back(std::move(value)); }
  /// Removes a member.
  void remove() { isRemoved_ = true; }

  [[nodiscard]] bool isNone() const {
    return !value_ && !isRemoved_ && members_.empty() && elements_.empty() && appended_.empty();
  }

private:
  friend class JsonRewriter;

  struct Member;

  /// The value that results if there was none before.
  [[nodiscard]] JsonTree made() const;

  std::optional<JsonTree> value_;
  bool isRemoved_ = false;
  std::deque<Member> members_; ///< in order of request; a deque keeps references valid
  std::map<std::size_t, JsonChange> elements_;
  std::vector<JsonTree> appended_;
};

struct JsonChange::Member {
  std::string key;
  JsonChange change;
};

/// Returns `text` with the changes applied. `text` must be valid JSON. Additions go on one line and
/// copy the whitespace of their neighbours. Errors: badInput with a JSON pointer, for a change to a
/// value of another type, to an absent element, or to a member that occurs twice. Throws
/// std::bad_alloc. Time: linear in the text.
[[nodiscard]] Result<std::string> changedJson(std::string_view text, const JsonChange& change);

} // namespace lichen
