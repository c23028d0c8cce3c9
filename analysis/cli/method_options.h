// SPDX-License-Identifier: MIT
// The methods of `lichen bake`: each one's options, and the bake that they describe.
#pragma once

#include "command.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

/// What is told of the method and to it.
struct MethodOptions {
  Method method = Method::tiling;
  int bits = 0; ///< of the tables' channels
  TilingOptions tiling;
  TextonOptions texton;
  MaterialNoise material; ///< what the method leaves to the material
};

/// The options of textons that mixes have too, but for --precision.
void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material);

/// --method, and the options of each method in a group of its own.
void addMethodOptions(CLI::App& verb, MethodOptions& options);

/// Refuses options of another method than the one that was chosen.
[[nodiscard]] Result<void> checkMethodOptions(const CLI::App& verb, const MethodOptions& options);

/// A noise of any method, and what is known of its making.
struct MethodBake {
  Noise noise; ///< its tables numbered from 0
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
  std::vector<MapTransportBound> transportBounds; ///< of tiling
  std::optional<TextonQuality> texton;            ///< of a texton
};

/// Bakes the maps by the method chosen; `borders` as MaterialSet::periodic.
[[nodiscard]] Result<MethodBake> bakeBy(const MethodOptions& options, const std::string& name,
                                        std::span<const MapExemplar> maps, Periodic borders,
                                        const Progress& progress);

} // namespace lichen::cli
