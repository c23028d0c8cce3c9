// SPDX-License-Identifier: MIT
// The bakes of all methods in one form: what they take, and what they return.
#pragma once

#include <lichen/bundle.h>
#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lichen {

/// The options of a bake by one method, in the order of Method.
using MethodOptions = std::variant<TilingOptions, TextonOptions, LocalRandomPhaseOptions,
                                   MultipleKernelsOptions, QuiltingOptions>;
static_assert(std::variant_size_v<MethodOptions> == std::variant_size_v<MethodMap>);

[[nodiscard]] inline Method methodOf(const MethodOptions& options) {
  return Method(options.index());
}

/// What a bake knows of its noise beyond what the noise holds. Members of other methods than the
/// noise's are 0 or empty.
struct BakeFigures {
  bool bordersWereKept = true; ///< opposite borders of the exemplar fit, or were taken to
  double structure = 0.0;      ///< share of the power with the phases of the exemplar
  double strength = 0.0;       ///< how clearly the exemplar repeats
  TextonQuality quality;
  std::vector<SpectrumError> spectrumErrors;
};

/// A noise baked by any method.
struct MethodBake {
  Noise noise; ///< table indices start at 0
  std::vector<Table> tables;
  BakeFigures figures;
  std::string_view borderTreatment = "blends"; ///< what the bake does with borders that do not fit
  std::vector<std::string> notes;              ///< for the user, one sentence each
};

} // namespace lichen
