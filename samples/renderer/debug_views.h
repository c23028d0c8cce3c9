// SPDX-License-Identifier: MIT
// Debug views: each shows one quantity of the surfaces instead of the shaded picture.
#pragma once

#include <lichen/result.h>

#include <string>
#include <string_view>
#include <vector>

namespace lichen::renderer {

[[nodiscard]] std::vector<std::string_view> debugViewNames();

/// The shaders' DEBUG_ constant for a name; DEBUG_NONE for an empty name. Errors: usage, listing
/// the valid names.
[[nodiscard]] Result<int> debugViewValue(const std::string& name);

} // namespace lichen::renderer
