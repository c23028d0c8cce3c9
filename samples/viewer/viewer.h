// SPDX-License-Identifier: MIT
// lichen-view without its command line: a window that shows a scene until it is closed.
#pragma once

#include "command_line.h"

namespace lichen::renderer {

/// Returns when the user closes the window. Errors: badInput for a scene that cannot be read at
/// the start; environment without a display or a device that presents to it, and, with `validate`,
/// for messages of the validation layers. Throws a Failure, with errors of the same kinds.
[[nodiscard]] Result<void> view(const ViewCommand& command);

} // namespace lichen::renderer
