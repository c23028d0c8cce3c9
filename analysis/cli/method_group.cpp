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
    if (std::optional<std::string> given = givenOf(verb, groupOf(other));
        given && other != method)
      return ForeignOption{std::move(*given), other};
  return std::nullopt;
}

Accepted<PointProcess> pointProcess() {
  return oneOf<PointProcess>(
      {{"stratified", PointProcess::stratified}, {"poisson", PointProcess::poisson}});
}

} // namespace lichen::cli
