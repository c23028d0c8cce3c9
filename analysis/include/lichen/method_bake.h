// SPDX-License-Identifier: MIT
// What the bakes of all methods take, in one form.
#pragma once

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <variant>

namespace lichen {

/// The options of a bake by one method, in the order of Method.
using MethodOptions = std::variant<TilingOptions, TextonOptions, LocalRandomPhaseOptions,
                                   MultipleKernelsOptions, QuiltingOptions>;
static_assert(std::variant_size_v<MethodOptions> == std::variant_size_v<MethodMap>);

[[nodiscard]] inline Method methodOf(const MethodOptions& options) {
  return Method(options.index());
}

} // namespace lichen
