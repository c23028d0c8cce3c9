// SPDX-License-Identifier: MIT
// Names of noises, from the user or from file names.
#pragma once

#include "options.h"

#include <string>

namespace lichen::cli {

/// Replaces bytes that are not UTF-8 with underscores, since JSON strings must be UTF-8.
[[nodiscard]] std::string asUtf8(const std::string& text);

/// The option --name of the verbs that bake.
[[nodiscard]] Accepted<std::string> nameText();

} // namespace lichen::cli
