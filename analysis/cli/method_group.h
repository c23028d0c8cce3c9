// SPDX-License-Identifier: MIT
// Options that belong to one noise method: a group of the help, refused with another method.
#pragma once

#include "options.h"

#include <lichen/bundle.h>

#include <optional>
#include <string>

namespace lichen::cli {

/// The heading of the method's options in help.
[[nodiscard]] std::string groupOf(Method method);

/// An option of another method than `method` that was given.
struct ForeignOption {
  std::string name;
  Method method{};
};
[[nodiscard]] std::optional<ForeignOption> foreignOption(const CLI::App& verb, Method method);

/// --points of the verbs that have it.
[[nodiscard]] Accepted<PointProcess> pointProcess();

} // namespace lichen::cli
