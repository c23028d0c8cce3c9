// SPDX-License-Identifier: MIT
// Range checks for TextonOptions.
#pragma once

#include <lichen/texton.h>

namespace lichen::texton {

/// Returns a usage error that names the option outside its range.
[[nodiscard]] Result<void> checkTextonOptions(const TextonOptions& options);

} // namespace lichen::texton
