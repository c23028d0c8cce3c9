// SPDX-License-Identifier: MIT
// Groups of options by method; see method_group.h.
#include "method_group.h"

namespace lichen::cli {

std::string groupOf(Method method) {
  switch (method) {
  case Method::texton:
    return "Texton";
  default:
    return "Tiling";
  }
}

std::optional<ForeignOption> foreignOption(const CLI::App& verb, Method method) {
  for (const Method other : {Method::tiling, Method::texton})
    for (const CLI::Option* option : verb.get_options())
      if (other != method && option->get_group() == groupOf(other) && option->count() > 0)
        return ForeignOption{option->get_name(), other};
  return std::nullopt;
}

Accepted<PointProcess> pointProcess() {
  return oneOf<PointProcess>(
      {{"stratified", PointProcess::stratified}, {"poisson", PointProcess::poisson}});
}

} // namespace lichen::cli
