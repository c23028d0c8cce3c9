// SPDX-License-Identifier: MIT
// JSON text -> nlohmann::json; see json_builder.h.
#include "json_builder.h"

#include <utility>
#include <vector>

namespace lichen {
namespace {

using nlohmann::json;

/// Receives the parser's events. It adds each value empty and fills it in place, so that no
/// temporary ever holds a nested value.
class Builder : public json::json_sax_t {
public:
  Builder(json& root, std::size_t mostValues) : root_(root), valuesLeft_(mostValues) {}

  [[nodiscard]] const std::optional<JsonFault>& fault() const { return fault_; }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(json::number_integer_t value) override { return add(value); }
  bool number_unsigned(json::number_unsigned_t value) override { return add(value); }
  bool number_float(json::number_float_t value, const std::string&) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(json::binary_t& value) override { return add(std::move(value)); }
  bool start_object(std::size_t) override { return open(json::value_t::object); }
  bool start_array(std::size_t) override { return open(json::value_t::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t byte, const std::string&, const json::exception& error) override {
    const bool isRange = dynamic_cast<const json::out_of_range*>(&error) != nullptr;
    fault_ = JsonFault{isRange ? JsonFault::Kind::range : JsonFault::Kind::syntax, byte};
    return false;
  }

private:
  json& place(json value) {
    if (open_.empty())
      return root_ = std::move(value);
    json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return parent.back();
    }
    json& member = parent[key_];
    dismantle(member); // an earlier member of the same name
    return member = std::move(value);
  }
  /// Counts one more value; stops the parse at the limit.
  bool count() {
    if (valuesLeft_ == 0)
      fault_ = JsonFault{JsonFault::Kind::count};
    else
      --valuesLeft_;
    return !fault_;
  }
  bool add(json value) {
    if (!count())
      return false;
    place(std::move(value));
    return true;
  }
  bool open(json::value_t type) {
    if (!count())
      return false;
    open_.push_back(&place(type));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  json& root_;
  std::size_t valuesLeft_;
  /// The arrays and objects that contain the next value. None moves before it is closed.
  std::vector<json*> open_;
  std::string key_;
  std::optional<JsonFault> fault_;
};

} // namespace

std::optional<JsonFault> buildJson(std::span<const std::byte> text, std::size_t mostValues,
                                   nlohmann::json& document) {
  Builder builder(document, mostValues);
  const auto* begin = reinterpret_cast<const char*>(text.data());
  json::sax_parse(begin, begin + text.size(), &builder);
  return builder.fault();
}

void dismantle(nlohmann::json& value) noexcept {
  if (auto* array = value.get_ptr<json::array_t*>()) {
    for (; !array->empty(); array->pop_back())
      dismantle(array->back());
  } else if (auto* object = value.get_ptr<json::object_t*>()) {
    for (; !object->empty(); object->erase(object->begin()))
      dismantle(object->begin()->second);
  }
}

} // namespace lichen
