// SPDX-License-Identifier: MIT
// Checks of single JSON values; see json_place.h.
#include "json_place.h"

#include "printable.h"

#include <cmath>
#include <sstream>

namespace lichen::renderer {
namespace {

std::string describe(const nlohmann::json& value) {
  if (value.is_array() || value.is_object())
    return std::string("an ") + value.type_name();
  return printable(value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

std::string describe(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string range(double low, double high) {
  if (low <= -kLargest && high >= kLargest)
    return "a finite number";
  if (high >= kLargest)
    return "a number of at least " + describe(low);
  return "a number in [" + describe(low) + ", " + describe(high) + "]";
}

const nlohmann::json kEmptyObject = nlohmann::json::object();

} // namespace

void Place::fail(const std::string& what) const {
  throw Fault{(pointer_.empty() ? std::string("/") : pointer_) + ": " + what};
}

std::optional<Place> Place::find(const char* key) const {
  if (!value_->is_object())
    fail(describe(*value_) + " is invalid; expected an object");
  const auto found = value_->find(key);
  if (found == value_->end())
    return std::nullopt;
  return Place(*found, pointer_ + "/" + key);
}

Place Place::member(const char* key) const {
  std::optional<Place> found = find(key);
  if (!found)
    fail(std::string("the required member \"") + key + "\" is missing");
  return *found;
}

void Place::each(const char* key,
                 const std::function<void(const Place&, std::size_t)>& visit) const {
  const std::optional<Place> array = find(key);
  if (!array)
    return;
  if (!array->value_->is_array() || array->value_->empty())
    array->fail(describe(*array->value_) + " is invalid; expected a non-empty array");
  if (array->value_->size() > kMaxElements)
    array->fail(std::to_string(array->value_->size()) + " elements are too many; the limit is " +
                std::to_string(kMaxElements));
  for (std::size_t i = 0; i < array->value_->size(); ++i)
    visit(array->at(i), i);
}

Place Place::at(std::size_t index) const {
  return {(*value_)[index], pointer_ + "/" + std::to_string(index)};
}

std::size_t Place::countOf(const char* key) const {
  const std::optional<Place> array = find(key);
  return array && array->value_->is_array() ? array->value_->size() : 0;
}

std::size_t Place::asIndex(std::size_t limit) const {
  // Check the type first: get<std::uint64_t> converts negative values to huge ones.
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() >= limit)
    fail(describe(*value_) + " is invalid; " +
         (limit == 0 ? std::string("the document has nothing to refer to")
                     : "expected an index from 0 to " + std::to_string(limit - 1)));
  return value_->get<std::size_t>();
}

std::optional<std::size_t> Place::index(const char* key, std::size_t limit) const {
  const std::optional<Place> found = find(key);
  if (!found)
    return std::nullopt;
  return found->asIndex(limit);
}

std::uint64_t Place::integer(const char* key, std::uint64_t low, std::uint64_t high,
                             std::optional<std::uint64_t> absent) const {
  const std::optional<Place> found = find(key);
  if (!found && absent)
    return *absent;
  const Place place = member(key);
  const nlohmann::json& value = *place.value_;
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < low ||
      value.get<std::uint64_t>() > high)
    place.fail(describe(value) + " is invalid; expected an integer from " + std::to_string(low) +
               " to " + std::to_string(high));
  return value.get<std::uint64_t>();
}

std::optional<std::uint64_t> Place::oneOf(const char* key,
                                          std::initializer_list<std::uint64_t> accepted) const {
  const std::optional<Place> found = find(key);
  if (!found)
    return std::nullopt;
  std::string list;
  for (const std::uint64_t value : accepted) {
    if (found->value_->is_number_unsigned() && found->value_->get<std::uint64_t>() == value)
      return value;
    list += (list.empty() ? "" : ", ") + std::to_string(value);
  }
  found->fail(describe(*found->value_) + " is invalid; expected one of " + list);
}

double Place::asNumber(double low, double high) const {
  const double value = value_->is_number() ? value_->get<double>() : 0.0;
  if (!value_->is_number() || value < low || value > high || std::abs(value) > kLargest)
    fail(describe(*value_) + " is invalid; expected " + range(low, high));
  return value;
}

double Place::number(const char* key, double absent, double low, double high) const {
  const std::optional<Place> found = find(key);
  return found ? found->asNumber(low, high) : absent;
}

std::optional<std::string> Place::string(const char* key) const {
  const std::optional<Place> found = find(key);
  if (!found)
    return std::nullopt;
  if (!found->value_->is_string())
    found->fail(describe(*found->value_) + " is invalid; expected a string");
  return found->value_->get<std::string>();
}

std::string Place::oneOf(const char* key, std::initializer_list<const char*> accepted) const {
  const std::string value = string(key).value_or(*accepted.begin());
  std::string list;
  for (const char* each : accepted) {
    if (value == each)
      return value;
    list += (list.empty() ? "" : ", ") + std::string(each);
  }
  fail(std::string(key) + " " + printable(value) + " is invalid; expected one of " + list);
}

bool Place::boolean(const char* key) const {
  const std::optional<Place> found = find(key);
  if (found && !found->value_->is_boolean())
    found->fail(describe(*found->value_) + " is invalid; expected true or false");
  return found && found->value_->get<bool>();
}

std::optional<Place> Place::findExtension(const char* name) const {
  const std::optional<Place> extensions = find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

Place Place::extension(const char* name) const {
  return findExtension(name).value_or(Place(kEmptyObject, pointer_));
}

} // namespace lichen::renderer
