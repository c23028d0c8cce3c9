// SPDX-License-Identifier: MIT
// Names that are given to noises, by the user or after files.
#pragma once

#include "options.h"

#include <string>

namespace lichen::cli {

/// Bytes that are not UTF-8, of which names in JSON consist, become underscores.
[[nodiscard]] std::string asUtf8(const std::string& text);

/// --name of the verbs that bake.
[[nodiscard]] Accepted<std::string> nameText();

} // namespace lichen::cli
