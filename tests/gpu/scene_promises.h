// SPDX-License-Identifier: MIT
// What the renderer relies on in a scene that the loader gives it.
#pragma once

#include "scene.h"

#include <string>

namespace lichen::test {

/// The promise that a scene breaks, empty when it keeps all.
[[nodiscard]] std::string brokenPromise(const renderer::Scene& scene);

} // namespace lichen::test
