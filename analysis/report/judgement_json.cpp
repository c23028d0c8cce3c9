// SPDX-License-Identifier: MIT
// Measures, kernels and risks -> JSON.
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

Json jsonOf(const KernelComparison& kernels) {
  Json list = Json::array();
  const std::pair<const char*, const KernelJudgement*> all[] = {
      {"this texton", &kernels.texton},
      {"luminance texton", &kernels.luminance},
      {"random phase, cropped", &kernels.randomPhase}};
  for (const auto& [name, kernel] : all)
    list.push_back({{"name", name},
                    {"modelError", kernel->modelError},
                    {"flatness", kernel->flatness},
                    {"impactsNeeded", kernel->impactsNeeded()}});
  return list;
}

Json jsonOf(const Risk& risk, SettingWords words) {
  return {{"name", risk.name},
          {"score", risk.score},
          {"level", nameOf(risk.level)},
          {"sentence", risk.sentence},
          {"remedy", remedyOf(risk, words)}};
}

} // namespace lichen
