// SPDX-License-Identifier: MIT
// Measures, kernels and risks -> JSON.
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

JsonTree jsonOf(const KernelComparison& kernels) {
  JsonTree list = JsonTree::array();
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

JsonTree jsonOf(const Risk& risk) {
  return {{"name", risk.name},
          {"score", risk.score},
          {"level", nameOf(risk.level)},
          {"sentence", risk.sentence},
          {"remedy", remedyOf(risk)}};
}

} // namespace lichen
