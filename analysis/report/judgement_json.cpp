// SPDX-License-Identifier: MIT
// Measures and risks -> JSON.
#include <lichen/judgement_json.h>

#include <nlohmann/json.hpp>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

} // namespace

Json jsonOf(const Measure& measure) {
  return {{"name", measure.name},
          {"meaning", measure.meaning},
          {"unit", measure.unit},
          {"value", orNull(measure.value)},
          {"target", orNull(measure.target)},
          {"met", measure.value && measure.target ? Json(!measure.isMissed()) : Json()},
          {"remark", measure.remark}};
}

Json jsonOf(const Risk& risk, SettingWords words) {
  return {{"name", risk.name},
          {"score", risk.score},
          {"level", nameOf(risk.level)},
          {"sentence", risk.sentence},
          {"remedy", remedyOf(risk, words)}};
}

} // namespace lichen
