// SPDX-License-Identifier: MIT
// Measures and risks -> JSON.
#include <lichen/judgement_json.h>

namespace lichen {
namespace {

JsonTree orNull(const std::optional<double>& value) {
  return value ? JsonTree(*value) : JsonTree();
}

} // namespace

JsonTree jsonOf(const Measure& measure) {
  return {{"name", measure.name},
          {"meaning", measure.meaning},
          {"unit", measure.unit},
          {"value", orNull(measure.value)},
          {"target", orNull(measure.target)},
          {"met", measure.value && measure.target ? JsonTree(!measure.isMissed()) : JsonTree()},
          {"remark", measure.remark}};
}

JsonTree jsonOf(const Risk& risk) {
  return {{"name", risk.name},
          {"score", risk.score},
          {"level", nameOf(risk.level)},
          {"sentence", risk.sentence},
          {"remedy", risk.remedy}};
}

} // namespace lichen
