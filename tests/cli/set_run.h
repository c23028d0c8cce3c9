// SPDX-License-Identifier: MIT
// Material sets of uniform maps, and runs of `lichen bake` on them.
#pragma once

#include "command_run.h"

#include <string>
#include <utility>
#include <vector>

namespace lichen::cli_test {

using Pixel = std::vector<float>;

[[nodiscard]] SrgbImage flat(const Pixel& value, int width = 4, int height = 4);

// Values that 8-bit files store exactly.
inline float code(int value) { return float(value) / 255.0f; }
inline const Pixel kColor{code(200), code(100), code(50)};
/// A unit normal, rounded to 8 bits, that leans left and down in the image. Its slopes are
/// positive, since our EXR reader requires positive values. kNormalDown is its mirror image.
inline const Pixel kNormal{code(66), code(82), code(230)};
inline const Pixel kNormalDown{code(66), code(173), code(230)};

/// A file of a set, and its only value.
using FlatFile = std::pair<std::string, Pixel>;

/// Writes uniform maps into a new folder, and returns its path.
std::string writeSet(const Workplace& workplace, const std::vector<FlatFile>& files);

void makeFolder(const Workplace& workplace, const std::string& name);

/// Bakes set.glb, requires that `check` accepts it, and returns the report of --json.
nlohmann::json baked(const Workplace& workplace, const Arguments& inputs,
                     const Arguments& more = {});

} // namespace lichen::cli_test
