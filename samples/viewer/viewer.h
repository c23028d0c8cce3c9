// SPDX-License-Identifier: MIT
// lichen-view without its command line: shows a scene in a window until the user closes it.
#pragma once

#include "program.h"

namespace lichen::renderer {

struct ViewCommand : SceneOptions {
  std::string output; ///< folder for screenshots
};

/// Returns when the user closes the window. Errors: badInput if the scene cannot be read at
/// startup; environment without a display or a device that can present to it, and, with `validate`,
/// if the validation layers report anything. Also throws a Failure with errors of these kinds.
[[nodiscard]] Result<void> view(const ViewCommand& command);

} // namespace lichen::renderer
