// SPDX-License-Identifier: MIT
// Sets of maps of one value, and runs of `lichen bake` on them.
#pragma once

#include "command_run.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace lichen::cli_test {

using Pixel = std::vector<float>;

[[nodiscard]] SrgbImage flat(const Pixel& value, int width = 4, int height = 4);

// Codes of 8 bits, so that files hold them exactly.
inline float code(int value) { return float(value) / 255.0f; }
inline const Pixel kColor{code(200), code(100), code(50)};
/// A unit normal that leans to the left and down the image, to a code of 8 bits; its slopes are
/// positive, as our reader of EXR wants values. Then its mirror image.
inline const Pixel kNormal{code(66), code(82), code(230)};
inline const Pixel kNormalDown{code(66), code(173), code(230)};

void makeFolder(const Workplace& workplace, const std::string& name);

/// Bakes set.glb, which `check` finds sound, and returns what --json says.
nlohmann::json baked(const Workplace& workplace, Arguments inputs, const Arguments& more = {});

} // namespace lichen::cli_test
