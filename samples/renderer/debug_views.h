// SPDX-License-Identifier: MIT
// One quantity of the surfaces instead of their shading.
#pragma once

#include <lichen/result.h>

#include <string>
#include <string_view>
#include <vector>

namespace lichen::renderer {

[[nodiscard]] std::vector<std::string_view> debugViewNames();

/// The shaders' DEBUG_ constant of a name; DEBUG_NONE of none. Errors: usage, with the names there
/// are.
[[nodiscard]] Result<int> debugViewValue(const std::string& name);

} // namespace lichen::renderer
