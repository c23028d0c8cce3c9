// SPDX-License-Identifier: MIT
// Whether options of a texton's bake are ones that it takes.
#pragma once

#include <lichen/texton.h>

namespace lichen::texton {

/// The Error, usage, names the option that is outside its range.
[[nodiscard]] Result<void> checkTextonOptions(const TextonOptions& options);

} // namespace lichen::texton
