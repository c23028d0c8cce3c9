// SPDX-License-Identifier: MIT
// How files become exemplars: the options that bake and compare share, so that what was baked is
// what a result is compared with.
#pragma once

#include "bake_risks.h"
#include "command.h"
#include "memory_need.h"

#include <lichen/material_set.h>
#include <lichen/noise_report.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

struct ExemplarOptions {
  MaterialSetOptions set; ///< but for the crop
  std::optional<std::array<int, 4>> crop;
  Flattening flattening;
  bool keepsOriginals = false; ///< of maps that are flattened
  BakeMemory bakeMemory;       ///< of the method that bakes them; none for a comparison
};

/// Exemplars, and how they came from their files.
struct ReadExemplar {
  MaterialSet set;
  std::vector<ExemplarOrigin> origins; ///< of each map
};

/// --crop, --size, --normal, --alpha, --flatten and --periodic of a verb.
void addExemplarOptions(CLI::App& verb, ExemplarOptions& options);

/// Reads the files, as readMaterialSet() does, and flattens their maps as told. What was done is
/// in sentences of the set's notes.
[[nodiscard]] Result<ReadExemplar> readExemplar(const std::vector<std::string>& inputs,
                                                const ExemplarOptions& options,
                                                const SharedOptions& shared);

} // namespace lichen::cli
