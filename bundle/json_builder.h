// SPDX-License-Identifier: MIT
// JSON text -> nlohmann::json or ordered_json, and the destruction of the former without
// allocation. nlohmann's destructor of a nested value moves its elements to a vector. When memory
// is exhausted, that throws inside a destructor and terminates the process. The engine plugin must
// survive that, so documents that are read are built and dismantled here. Documents that are
// written are plain values of nlohmann: writers report only that memory does not suffice for a
// large allocation.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lichen {

struct JsonFault {
  enum class Kind {
    syntax,
    range, ///< a number beyond the range of double
    count, ///< too many values
    depth, ///< nested too deep
    name   ///< two members of an object have the same name
  };
  Kind kind = Kind::syntax;
  std::size_t byte = 0; ///< byte offset of a fault that the parser found
  std::string name;     ///< of a fault of kind `name`
};

/// Empties an array or object, leaves first. The recursion depth equals the nesting depth.
inline void dismantle(nlohmann::json& value) noexcept {
  if (auto* array = value.get_ptr<nlohmann::json::array_t*>()) {
    for (; !array->empty(); array->pop_back())
      dismantle(array->back());
  } else if (auto* object = value.get_ptr<nlohmann::json::object_t*>()) {
    for (; !object->empty(); object->erase(object->begin()))
      dismantle(object->begin()->second);
  }
}

/// Receives the parser's events. It adds each value empty and fills it in place, so that no
/// temporary ever holds a nested value.
template <class Json>
class JsonBuilder : public nlohmann::json_sax<Json> {
public:
  JsonBuilder(Json& root, std::size_t mostValues, std::size_t mostDepth)
      : root_(root), valuesLeft_(mostValues), mostDepth_(mostDepth) {}

  [[nodiscard]] const std::optional<JsonFault>& fault() const { return fault_; }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(typename Json::number_integer_t value) override { return add(value); }
  bool number_unsigned(typename Json::number_unsigned_t value) override { return add(value); }
  bool number_float(typename Json::number_float_t value, const std::string&) override {
    return add(value);
  }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(typename Json::binary_t&) override { return false; } // text has none
  bool start_object(std::size_t) override { return open(Json::value_t::object); }
  bool start_array(std::size_t) override { return open(Json::value_t::array); }
  bool end_object() override { return checkNames() && close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t byte, const std::string&,
                   const nlohmann::json::exception& error) override {
    const bool isRange = dynamic_cast<const typename Json::out_of_range*>(&error) != nullptr;
    return stop(isRange ? JsonFault::Kind::range : JsonFault::Kind::syntax, byte, {});
  }

private:
  static constexpr bool kIsOrdered = std::is_same_v<Json, nlohmann::ordered_json>;

  Json& place(Json value) {
    if (open_.empty())
      return root_ = std::move(value);
    Json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return parent.back();
    }
    if constexpr (kIsOrdered) { // operator[] would compare the name with all earlier ones
      auto& members = parent.template get_ref<typename Json::object_t&>();
      return members.emplace_back(key_, std::move(value)).second;
    } else {
      Json& member = parent[key_];
      dismantle(member); // an earlier member of the same name
      return member = std::move(value);
    }
  }
  /// Stops the parse if two members of the last open object have the same name.
  bool checkNames() {
    if constexpr (kIsOrdered) {
      std::vector<std::string_view> names;
      for (const auto& member : open_.back()->template get_ref<typename Json::object_t&>())
        names.push_back(member.first);
      std::sort(names.begin(), names.end());
      if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
        return stop(JsonFault::Kind::name, 0, std::string(*twice));
    }
    return true;
  }
  /// Stops the parse.
  bool stop(JsonFault::Kind kind, std::size_t byte, std::string name) {
    fault_ = JsonFault{kind, byte, std::move(name)};
    return false;
  }
  bool add(Json value) {
    if (valuesLeft_-- == 0)
      return stop(JsonFault::Kind::count, 0, {});
    place(std::move(value));
    return true;
  }
  bool open(typename Json::value_t type) {
    if (valuesLeft_-- == 0)
      return stop(JsonFault::Kind::count, 0, {});
    if (open_.size() == mostDepth_)
      return stop(JsonFault::Kind::depth, 0, {});
    open_.push_back(&place(type));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  std::size_t valuesLeft_, mostDepth_;
  /// The arrays and objects that contain the next value. None moves before it is closed.
  std::vector<Json*> open_;
  std::string key_;
  std::optional<JsonFault> fault_;
};

/// Parses `text` into `document` as json::parse() does: of members of the same name the last one
/// counts, or in an ordered document two are a fault. Reads at most `mostValues` values, counted at
/// all depths, and `mostDepth` levels of arrays and objects. Throws std::bad_alloc. After an
/// exception or a fault, `document` holds the values read so far; pass it to dismantle(). Time in
/// an ordered document: n log n in the members of an object.
template <class Json>
[[nodiscard]] std::optional<JsonFault> buildJson(std::span<const std::byte> text,
                                                 std::size_t mostValues, std::size_t mostDepth,
                                                 Json& document) {
  JsonBuilder<Json> builder(document, mostValues, mostDepth);
  const auto* begin = reinterpret_cast<const char*>(text.data());
  Json::sax_parse(begin, begin + text.size(), &builder);
  return builder.fault();
}

} // namespace lichen
