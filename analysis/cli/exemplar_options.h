// SPDX-License-Identifier: MIT
// Files -> exemplars: the options that `bake`, `mix` and `compare` share, and their record in a
// bundle, so that a comparison makes exactly the exemplar that was baked.
#pragma once

#include "bake_risks.h"
#include "command.h"
#include "memory_need.h"
#include "outliers_option.h"
#include "rectify_option.h"

#include <lichen/material_set.h>
#include <lichen/noise_report.h>
#include <lichen/structure.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

struct ExemplarOptions {
  MaterialSetOptions set{}; ///< `crop` below replaces its crop
  std::optional<std::array<int, 4>> crop{};
  Flattening flattening{};
  OutlierUse outliers{};
  Rectification rectification{};
  bool findsStructure =
      false; ///< whether to measure what repeats, as automatic rectification needs
  bool keepsOriginals = false; ///< whether to return the maps before flattening and filling
  BakeMemory bakeMemory{};     ///< of the method that bakes; zeros if none does
};

/// Exemplars, and how each was made from its file.
struct ReadExemplar {
  MaterialSet set;
  std::vector<ExemplarOrigin> origins; ///< one per map
  Preparation preparation;             ///< what the options came to
  Structure structure;                 ///< if that was to be found
  double widthShare = 1.0;             ///< of the first map, over what it was before --rectify
};

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

/// Reads the files with readMaterialSet(), and flattens, fills and rectifies the maps as the
/// options ask. The notes of the set describe all.
[[nodiscard]] Result<ReadExemplar> readExemplar(const std::vector<std::string>& inputs,
                                                const ExemplarOptions& options,
                                                const SharedOptions& shared);

} // namespace lichen::cli
