// SPDX-License-Identifier: MIT
// `lichen compare --methods`: one exemplar under every method.
#pragma once

#include "command.h"
#include "memory_need.h"

#include <lichen/exemplar.h>

#include <string>
#include <vector>

namespace lichen::cli {

/// A photograph's map to bake by every method at its defaults.
struct ComparedExemplar {
  const std::string& path;
  const MapExemplar& map;
  Periodic borders{};
  const std::vector<std::string>& notes;
};

/// What compareMethods() needs.
[[nodiscard]] BakeMemory memoryOfMethods();

/// Bakes, measures and prints a line a method; also writes the page `report`, unless empty. Returns
/// the exit code.
[[nodiscard]] Result<int> compareMethods(const ComparedExemplar& exemplar,
                                         const std::string& report, const SharedOptions& shared);

} // namespace lichen::cli
