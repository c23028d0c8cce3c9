// SPDX-License-Identifier: MIT
// Applies changes to JSON text; see json_changes.h. One pass copies the text and stops at each
// change.
// Source: RFC 8259.
#include "json_changes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace lichen {

JsonChange& JsonChange::member(std::string_view key) {
  const auto found = std::find_if(members_.begin(), members_.end(),
                                  [&](const Member& member) { return member.key == key; });
  if (found != members_.end())
    return found->change;
  return members_.emplace_back(Member{std::string(key), {}}).change;
}

JsonTree JsonChange::made() const {
  if (value_)
    return *value_;
  JsonTree tree = appended_.empty() ? JsonTree::object() : JsonTree::array();
  for (const JsonTree& element : appended_)
    tree.push_back(element);
  for (const Member& member : members_)
    if (!member.change.isRemoved_)
      tree[member.key] = member.change.made();
  return tree;
}

/// Copies a text with changes. The text is valid JSON, so the scanner distinguishes only what it
/// needs.
class JsonRewriter {
public:
  explicit JsonRewriter(std::string_view text) : text_(text) {}

  std::string run(const JsonChange& change) {
    copySpace();
    value(change, "");
    out_ += text_.substr(at_);
    return std::move(out_);
  }

  struct Fault {
    Error error;
  };

private:
  [[noreturn]] static void fail(const std::string& pointer, const std::string& what) {
    throw Fault{{ErrorKind::badInput, pointer + ": " + what}};
  }

  [[nodiscard]] std::string_view space() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }
  void copySpace() { out_ += space(); }

  /// Reads a string with its quotes.
  std::string_view string() {
    const std::size_t begin = at_++;
    while (text_[at_] != '"')
      at_ += text_[at_] == '\\' ? 2u : 1u;
    ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// Reads a value.
  std::string_view skip() {
    const std::size_t begin = at_;
    int depth = 0;
    do {
      const char c = text_[at_];
      if (c == '"') {
        string();
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at_;
      } else if (c == '}' || c == ']') {
        --depth;
        ++at_;
      } else if (depth > 0) {
        ++at_;
      } else { // a number, true, false or null
        at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
      }
    } while (depth > 0);
    return text_.substr(begin, at_ - begin);
  }

  /// Reads a colon with the whitespace around it, which added members reuse.
  std::string_view passColon() {
    const std::size_t begin = at_;
    (void)space();
    ++at_;
    (void)space();
    return colon_ = text_.substr(begin, at_ - begin);
  }

  static std::string keyOf(std::string_view quoted) {
    if (quoted.find('\\') == std::string_view::npos)
      return std::string(quoted.substr(1, quoted.size() - 2));
    return nlohmann::json::parse(quoted).get<std::string>();
  }

  void value(const JsonChange& change, const std::string& pointer) {
    if (change.value_) {
      (void)skip();
      out_ += change.value_->compact();
    } else if (change.isNone()) {
      out_ += skip();
    } else if (change.members_.empty()) {
      if (text_[at_] != '[')
        fail(pointer, "not an array");
      array(change, pointer);
    } else {
      if (text_[at_] != '{')
        fail(pointer, "not an object");
      object(change, pointer);
    }
  }

  void object(const JsonChange& change, const std::string& pointer) {
    std::set<std::string> found;
    open();
    while (text_[at_] != '}') {
      const std::string_view quoted = string();
      const std::string key = keyOf(quoted);
      const auto member = std::find_if(change.members_.begin(), change.members_.end(),
                                       [&](const auto& each) { return each.key == key; });
      const std::string_view colon = passColon();
      static const JsonChange kNone{};
      const JsonChange& inside = member == change.members_.end() ? kNone : member->change;
      if (member != change.members_.end() && !found.insert(key).second)
        fail(pointer + "/" + key, "appears twice; expected once");
      if (inside.isRemoved_) {
        (void)skip();
      } else {
        startItem();
        out_ += quoted;
        out_ += colon;
        value(inside, pointer + "/" + key);
      }
      endItem();
    }
    for (const auto& member : change.members_)
      if (!found.contains(member.key) && !member.change.isRemoved_)
        addItem(JsonTree(member.key).compact() + std::string(colon_) +
                member.change.made().compact());
    close();
  }

  void array(const JsonChange& change, const std::string& pointer) {
    std::size_t count = 0;
    open();
    for (; text_[at_] != ']'; ++count) {
      startItem();
      const auto element = change.elements_.find(count);
      if (element == change.elements_.end())
        out_ += skip();
      else
        value(element->second, pointer + "/" + std::to_string(count));
      endItem();
    }
    if (!change.elements_.empty() && change.elements_.rbegin()->first >= count)
      fail(pointer + "/" + std::to_string(change.elements_.rbegin()->first), "absent");
    for (const JsonTree& element : change.appended_)
      addItem(element.compact());
    close();
  }

  /// The whitespace around the items of the array or object being copied: `before` precedes the
  /// next item, `after` follows the last one.
  struct Frame {
    std::string_view first, before, after;
    bool isEmpty = true;
  };

  void open() {
    out_ += text_[at_++];
    const std::string_view gap = space();
    frames_.push_back({gap, gap, {}, true});
  }
  void startItem() {
    Frame& frame = frames_.back();
    if (!frame.isEmpty) {
      out_ += frame.after;
      out_ += ',';
    }
    out_ += frame.before;
    frame.isEmpty = false;
  }
  /// Moves from the end of an item to the next item or the closing bracket.
  void endItem() {
    Frame& frame = frames_.back();
    frame.after = space();
    if (text_[at_] != ',')
      return;
    ++at_;
    frame.before = space();
  }
  void addItem(const std::string& item) {
    Frame& frame = frames_.back();
    out_ += frame.isEmpty ? "" : ",";
    out_ += frame.first;
    out_ += item;
    frame.isEmpty = false;
  }
  void close() {
    out_ += frames_.back().isEmpty ? frames_.back().first : frames_.back().after;
    out_ += text_[at_++];
    frames_.pop_back();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string out_;
  std::vector<Frame> frames_;
  std::string_view colon_ = ":";
};

Result<std::string> changedJson(std::string_view text, const JsonChange& change) {
  try {
    return JsonRewriter(text).run(change);
  } catch (JsonRewriter::Fault& fault) {
    return std::move(fault.error);
  }
}

} // namespace lichen
