// SPDX-License-Identifier: MIT
// Files -> exemplars: the options that `bake`, `mix` and `compare` share, and their record in a
// bundle, so that a comparison makes exactly the exemplar that was baked.
#pragma once

#include "command.h"

#include <lichen/bake_memory.h>
#include <lichen/exemplar_preparation.h>

#include <string>
#include <vector>

namespace lichen::cli {

/// What a verb does with exemplars, which decides the defaults of their options.
enum class ExemplarUse {
  bake,      ///< may find whole periods
  mix,       ///< as a bake, without that
  comparison ///< as the bundle says that a bake did; else without flattening and periods
};

/// Declares --crop, --size, --normal, --alpha, --flatten, --keep-outliers, --rectify and
/// --periodic.
void addExemplarOptions(CLI::App& verb, ExemplarOptions& options, ExemplarUse use);

/// Sets each option that the command line does not give to what a bundle recorded, and returns what
/// was taken from the record.
Preparation adoptPreparation(Preparation recorded, const CLI::App& verb, ExemplarOptions& options);
/// A preparation in words, of the options where there is one; empty if nothing was done.
[[nodiscard]] std::string describe(const Preparation& preparation);

/// Reads the files with readMaterialSet(), if there is memory for them and for a bake.
[[nodiscard]] Result<MaterialSet> readMaterial(const std::vector<std::string>& inputs,
                                               MaterialSetOptions reading,
                                               const BakeMemory& memory = {});
/// The same, and makes an exemplar of the maps, with a line of progress.
[[nodiscard]] Result<PreparedExemplar> readExemplar(const std::string& input,
                                                    const ExemplarOptions& options,
                                                    const SharedOptions& shared,
                                                    const BakeMemory& memory = {});

} // namespace lichen::cli
