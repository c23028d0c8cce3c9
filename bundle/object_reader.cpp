// SPDX-License-Identifier: MIT
// Typed access to one JSON object; see object_reader.h.
#include "object_reader.h"

#include <lichen/counted.h>

#include <algorithm>

namespace lichen {

using nlohmann::json;

namespace {

std::string shortest(double value) { return json(value).dump(); }

} // namespace

const json* memberOf(const json* value, std::string_view key) {
  if (value == nullptr || !value->is_object())
    return nullptr;
  const auto member = value->find(std::string(key));
  return member == value->end() ? nullptr : &*member;
}

const std::string* stringMember(const json& value, std::string_view key) {
  const json* member = memberOf(&value, key);
  return member == nullptr ? nullptr : member->get_ptr<const std::string*>();
}

ObjectReader::ObjectReader(const json& value, std::string pointer, FindingList& findings)
    : value_(value), pointer_(std::move(pointer)), findings_(findings) {
  if (!value_.is_object())
    findings_.error("type", pointer_, std::string(value_.type_name()) + "; expected an object");
}

bool ObjectReader::has(const char* key) const { return value_.is_object() && value_.contains(key); }

const json* ObjectReader::optional(const char* key) {
  asked_.emplace_back(key);
  return has(key) ? &value_[key] : nullptr;
}

const json* ObjectReader::required(const char* key) {
  const json* member = optional(key);
  if (member == nullptr && value_.is_object())
    findings_.error("required", pointerTo(key), "absent");
  return member;
}

void ObjectReader::error(const char* code, const char* key, std::string message) {
  findings_.error(code, pointerTo(key), std::move(message));
}

std::optional<double> ObjectReader::checkedNumber(const json& value, const std::string& pointer,
                                                  NumberRange range) {
  if (!value.is_number()) {
    findings_.error("type", pointer, std::string(value.type_name()) + "; expected a number");
    return std::nullopt;
  }
  const auto number = value.get<double>();
  if (!(number >= range.least && number <= range.most)) {
    findings_.error("range", pointer,
                    shortest(number) + "; expected " + shortest(range.least) + " to " +
                        shortest(range.most));
    return std::nullopt;
  }
  return number;
}

std::optional<double> ObjectReader::number(const char* key, NumberRange range) {
  const json* member = required(key);
  return member ? checkedNumber(*member, pointerTo(key), range) : std::nullopt;
}

double ObjectReader::numberOr(const char* key, NumberRange range, double fallback) {
  return optional(key) ? number(key, range).value_or(fallback) : fallback;
}

const json* ObjectReader::array(const char* key, std::size_t most) {
  const json* member = required(key);
  if (member == nullptr)
    return nullptr;
  if (!member->is_array()) {
    error("type", key, std::string(member->type_name()) + "; expected an array");
    return nullptr;
  }
  if (member->empty() || member->size() > most) {
    error("count", key,
          std::to_string(member->size()) + " elements; expected 1 to " + std::to_string(most));
    return nullptr;
  }
  return member;
}

std::optional<std::vector<double>> ObjectReader::numbers(const char* key, NumberRange range) {
  constexpr std::size_t kMostNumbers = 64; // levels, the longest list in the format
  const json* list = array(key, kMostNumbers);
  if (list == nullptr)
    return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 0; i < list->size(); ++i)
    if (const auto value =
            checkedNumber((*list)[i], pointerTo(key) + "/" + std::to_string(i), range))
      values.push_back(*value);
  if (values.size() != list->size())
    return std::nullopt;
  return values;
}

std::optional<std::array<double, 2>> ObjectReader::pair(const char* key, NumberRange range) {
  const auto values = numbers(key, range);
  if (values && values->size() == 2)
    return std::array{values->front(), values->back()};
  if (values)
    error("count", key, counted(values->size(), "value") + "; expected 2");
  return std::nullopt;
}

std::array<double, 2> ObjectReader::pairOr(const char* key, NumberRange range,
                                           const std::array<double, 2>& fallback) {
  return has(key) ? pair(key, range).value_or(fallback) : fallback;
}

std::optional<std::uint64_t> ObjectReader::integer(const char* key, std::uint64_t most,
                                                   const char* rangeCode, std::uint64_t least) {
  const json* member = required(key);
  if (member == nullptr)
    return std::nullopt;
  if (!member->is_number_integer()) {
    error("type", key, std::string(member->type_name()) + "; expected an integer");
    return std::nullopt;
  }
  const auto value =
      member->is_number_unsigned() ? std::optional(member->get<std::uint64_t>()) : std::nullopt;
  if (!value || *value < least || *value > most) {
    error(rangeCode, key,
          member->dump() + "; expected " + std::to_string(least) + " to " + std::to_string(most));
    return std::nullopt;
  }
  return value;
}

std::optional<std::string> ObjectReader::text(const char* key) {
  const json* member = required(key);
  if (member == nullptr)
    return std::nullopt;
  if (!member->is_string()) {
    error("type", key, std::string(member->type_name()) + "; expected a string");
    return std::nullopt;
  }
  return member->get<std::string>();
}

void ObjectReader::warnOfUnknown() {
  if (!value_.is_object())
    return;
  for (const auto& [key, member] : value_.items())
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
      findings_.warn("unknown-property", pointer_, quoted(key) + " has no meaning here");
}

} // namespace lichen
